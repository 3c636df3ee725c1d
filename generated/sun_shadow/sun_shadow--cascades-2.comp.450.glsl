#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform SunShadowParameters
{
    vec4 gOutputSize;
    vec4 gToShadowX;
    vec4 gToShadowY;
    vec4 gToShadowZ;
    vec4 gCascadeScale1;
    vec4 gCascadeOffset1;
    vec4 gCascadeScale2;
    vec4 gCascadeOffset2;
    vec4 gCascadeScale3;
    vec4 gCascadeOffset3;
    vec4 gCascadeFar;
    vec4 gCascadeSize;
    vec3 gDisc;
    float gFrameIndex;
    vec3 gShadowBias;
    float gSubsetCount;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutShadow;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _98 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _100 = _98 * parameters.gOutputSize.zw;
        vec2 _104 = parameters.gOutputSize.zw * 0.5;
        vec4 _107 = textureGather(gInCoarseDepth, fma(_98, parameters.gOutputSize.zw, -_104));
        vec4 _110 = textureGather(gInCoarseDepth, fma(_98, parameters.gOutputSize.zw, _104));
        float _111 = _107.y;
        float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
        float _115 = _107.x;
        float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
        float _119 = _107.z;
        float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
        float _123 = _110.z;
        float _126 = (_123 > 0.0) ? min(_123, 65504.0) : 65504.0;
        float _127 = _110.x;
        float _130 = (_127 > 0.0) ? min(_127, 65504.0) : 65504.0;
        vec3 _134 = vec3(_100 * _114, _114);
        bvec2 _156 = greaterThan(_100, parameters.gOutputSize.zw);
        bvec2 _158 = lessThan(_100, vec2(1.0) - parameters.gOutputSize.zw);
        float _164 = _126 - _114;
        vec2 _172 = mix(vec2(_164, _126), vec2(_114 - _118, _118), bvec2((_156.x ? abs(_118 - _114) : 131008.0) < (_158.x ? abs(_164) : 65504.0)));
        float _178 = _130 - _114;
        vec2 _186 = mix(vec2(_178, _130), vec2(_114 - _122, _122), bvec2((_156.y ? abs(_122 - _114) : 131008.0) < (_158.y ? abs(_178) : 65504.0)));
        float _190 = _172.x;
        vec3 _197 = vec3((_100 * _190) + (vec2(parameters.gOutputSize.z, 0.0) * _172.y), _190);
        float _205 = _186.x;
        vec3 _212 = vec3((_100 * _205) + (vec2(0.0, parameters.gOutputSize.w) * _186.y), _205);
        vec3 _217 = cross(vec3(dot(parameters.gToShadowX.xyz, _197), dot(parameters.gToShadowY.xyz, _197), dot(parameters.gToShadowZ.xyz, _197)), vec3(dot(parameters.gToShadowX.xyz, _212), dot(parameters.gToShadowY.xyz, _212), dot(parameters.gToShadowZ.xyz, _212)));
        float _218 = _217.z;
        bool _242 = _114 > parameters.gCascadeFar.x;
        bvec3 _243 = bvec3(_242);
        vec3 _244 = mix(vec3(1.0), parameters.gCascadeScale1.xyz, _243);
        float _246 = float(_242);
        vec3 _247 = fma(vec3(dot(parameters.gToShadowX.xyz, _134), dot(parameters.gToShadowY.xyz, _134), dot(parameters.gToShadowZ.xyz, _134)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _244, mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _243));
        float _248 = _244.z;
        vec2 _249 = _244.xy;
        vec2 _252 = clamp((-_217.xy) / vec2((abs(_218) > 9.9999996826552253889678874634872e-21) ? _218 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_248) / _249);
        vec2 _260 = max(parameters.gDisc.xy * _249, vec2(parameters.gDisc.z));
        vec2 _269 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _272 = floor(_98);
        vec2 _274 = floor(_272 * 0.5);
        vec2 _276 = _272 - (_274 * 2.0);
        vec2 _280 = _274 - (floor(_274 * 0.5) * 2.0);
        float _281 = _276.x;
        float _282 = _276.y;
        float _284 = abs(_281 - _282);
        float _285 = _280.y;
        float _290 = _280.x;
        vec2 _302 = vec2(fma(2.0, abs(_290 - _285), fma(8.0, _284, 4.0 * _282)) + _285, fma(2.0, abs(abs(_285 - _282) - _290), fma(4.0, _281, fma(-8.0, _284, 8.0))) + _290) * vec2(0.0625);
        float _307 = floor(parameters.gSubsetCount);
        float _310 = (_307 > 1.0) ? min(_307, 16.0) : 1.0;
        float _314 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _320 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_310, floor((_314 + 0.5) / _310), _314);
        float _324 = 6.283185482025146484375 * (_320.x + _302.x);
        float _325 = cos(_324);
        float _326 = sin(_324);
        float _329 = _320.y + _302.y;
        vec2 _330 = fract(vec2(0.5));
        float _332 = 6.283185482025146484375 * _330.x;
        float _333 = cos(_332);
        float _334 = sin(_332);
        vec2 _341 = _247.xy;
        vec2 _350 = clamp(floor(fma(_260 * sqrt(fract(_330.y + _329)), vec2(fma(_333, _325, -(_334 * _326)), fma(_333, _326, _334 * _325)), _341)) + vec2(0.5), vec2(0.5), _269);
        float _362 = _247.z;
        float _367 = -fma(parameters.gShadowBias.y, _114, parameters.gShadowBias.x);
        vec2 _371 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _373 = 6.283185482025146484375 * _371.x;
        float _374 = cos(_373);
        float _375 = sin(_373);
        vec2 _390 = clamp(floor(fma(_260 * sqrt(fract(_371.y + _329)), vec2(fma(_374, _325, -(_375 * _326)), fma(_374, _326, _375 * _325)), _341)) + vec2(0.5), vec2(0.5), _269);
        vec2 _407 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _409 = 6.283185482025146484375 * _407.x;
        float _410 = cos(_409);
        float _411 = sin(_409);
        vec2 _426 = clamp(floor(fma(_260 * sqrt(fract(_407.y + _329)), vec2(fma(_410, _325, -(_411 * _326)), fma(_410, _326, _411 * _325)), _341)) + vec2(0.5), vec2(0.5), _269);
        vec2 _443 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _445 = 6.283185482025146484375 * _443.x;
        float _446 = cos(_445);
        float _447 = sin(_445);
        vec2 _462 = clamp(floor(fma(_260 * sqrt(fract(_443.y + _329)), vec2(fma(_446, _325, -(_447 * _326)), fma(_446, _326, _447 * _325)), _341)) + vec2(0.5), vec2(0.5), _269);
        float _486 = -(((float(textureLod(gInShadowMap, vec2(fma(_246, parameters.gCascadeSize.x, _350.x), _350.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_367, _248, min(_362 + dot(_252, _350 - _341), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_246, parameters.gCascadeSize.x, _390.x), _390.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_367, _248, min(_362 + dot(_252, _390 - _341), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_246, parameters.gCascadeSize.x, _426.x), _426.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_367, _248, min(_362 + dot(_252, _426 - _341), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_246, parameters.gCascadeSize.x, _462.x), _462.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_367, _248, min(_362 + dot(_252, _462 - _341), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_114 < 65504.0) ? ((all(lessThanEqual(abs((_341 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_114 <= parameters.gCascadeFar.y)) ? fma(_486, 0.25, 1.0) : 1.0) : 1.0, _114, 0.0, 0.0));
        break;
    } while(false);
}

