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
    vec3 gBias;
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
        vec2 _94 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _96 = _94 * parameters.gOutputSize.zw;
        vec2 _100 = parameters.gOutputSize.zw * 0.5;
        vec4 _103 = textureGather(gInCoarseDepth, fma(_94, parameters.gOutputSize.zw, -_100));
        vec4 _106 = textureGather(gInCoarseDepth, fma(_94, parameters.gOutputSize.zw, _100));
        float _107 = _103.y;
        float _109 = (_107 > 0.0) ? _107 : 65504.0;
        float _111 = (_109 < 65504.0) ? _109 : 65504.0;
        float _112 = _103.x;
        float _114 = (_112 > 0.0) ? _112 : 65504.0;
        float _116 = (_114 < 65504.0) ? _114 : 65504.0;
        float _117 = _103.z;
        float _119 = (_117 > 0.0) ? _117 : 65504.0;
        float _121 = (_119 < 65504.0) ? _119 : 65504.0;
        float _122 = _106.z;
        float _124 = (_122 > 0.0) ? _122 : 65504.0;
        float _126 = (_124 < 65504.0) ? _124 : 65504.0;
        float _127 = _106.x;
        float _129 = (_127 > 0.0) ? _127 : 65504.0;
        float _131 = (_129 < 65504.0) ? _129 : 65504.0;
        vec3 _135 = vec3(_96 * _111, _111);
        vec2 _159 = vec2(parameters.gOutputSize.z, 0.0);
        float _174 = _126 - _111;
        vec2 _182 = mix(vec2(_174, _126), vec2(_111 - _116, _116), bvec2((all(lessThanEqual(abs(fma(_94, parameters.gOutputSize.zw, -_159) - vec2(0.5)), vec2(0.5))) ? abs(_116 - _111) : 131008.0) < (all(lessThanEqual(abs(fma(_94, parameters.gOutputSize.zw, _159) - vec2(0.5)), vec2(0.5))) ? abs(_174) : 65504.0)));
        float _183 = _182.x;
        vec3 _190 = vec3((_96 * _183) + (_159 * _182.y), _183);
        vec2 _197 = vec2(0.0, parameters.gOutputSize.w);
        float _212 = _131 - _111;
        vec2 _220 = mix(vec2(_212, _131), vec2(_111 - _121, _121), bvec2((all(lessThanEqual(abs(fma(_94, parameters.gOutputSize.zw, -_197) - vec2(0.5)), vec2(0.5))) ? abs(_121 - _111) : 131008.0) < (all(lessThanEqual(abs(fma(_94, parameters.gOutputSize.zw, _197) - vec2(0.5)), vec2(0.5))) ? abs(_212) : 65504.0)));
        float _221 = _220.x;
        vec3 _228 = vec3((_96 * _221) + (_197 * _220.y), _221);
        vec3 _233 = cross(vec3(dot(parameters.gToShadowX.xyz, _190), dot(parameters.gToShadowY.xyz, _190), dot(parameters.gToShadowZ.xyz, _190)), vec3(dot(parameters.gToShadowX.xyz, _228), dot(parameters.gToShadowY.xyz, _228), dot(parameters.gToShadowZ.xyz, _228)));
        float _234 = _233.z;
        bool _258 = _111 > parameters.gCascadeFar.x;
        bvec3 _259 = bvec3(_258);
        vec3 _260 = mix(vec3(1.0), parameters.gCascadeScale1.xyz, _259);
        float _262 = float(_258);
        vec3 _263 = fma(vec3(dot(parameters.gToShadowX.xyz, _135), dot(parameters.gToShadowY.xyz, _135), dot(parameters.gToShadowZ.xyz, _135)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _260, mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _259));
        float _264 = _260.z;
        vec2 _265 = _260.xy;
        vec2 _268 = clamp((-_233.xy) / vec2((abs(_234) > 9.9999996826552253889678874634872e-21) ? _234 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_264) / _265);
        vec2 _276 = max(parameters.gDisc.xy * _265, vec2(parameters.gDisc.z));
        vec2 _285 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _288 = floor(_94);
        float _293 = floor(parameters.gSubsetCount);
        float _296 = (_293 > 1.0) ? min(_293, 16.0) : 1.0;
        float _300 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _306 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_296, floor((_300 + 0.5) / _296), _300);
        vec2 _309 = floor(_288 * 0.5);
        vec2 _311 = _288 - (_309 * 2.0);
        vec2 _315 = _309 - (floor(_288 * 0.25) * 2.0);
        float _317 = _311.y;
        float _320 = _315.y;
        vec2 _326 = (abs(vec2(_311.x - _317, _315.x - _320)) * 2.0) + vec2(_317, _320);
        float _331 = 6.283185482025146484375 * fma(fma(4.0, _326.x, _326.y), 0.0625, _306.x);
        float _332 = cos(_331);
        float _333 = sin(_331);
        vec2 _338 = vec2(_288.y + 1.0, _288.x);
        vec2 _340 = floor(_338 * 0.5);
        vec2 _342 = _338 - (_340 * 2.0);
        vec2 _346 = _340 - (floor(_338 * 0.25) * 2.0);
        float _348 = _342.y;
        float _351 = _346.y;
        vec2 _357 = (abs(vec2(_342.x - _348, _346.x - _351)) * 2.0) + vec2(_348, _351);
        float _361 = fma(fma(4.0, _357.x, _357.y), 0.0625, _306.y);
        vec2 _362 = fract(vec2(0.5));
        float _364 = 6.283185482025146484375 * _362.x;
        float _365 = cos(_364);
        float _366 = sin(_364);
        vec2 _373 = _263.xy;
        vec2 _382 = clamp(floor(fma(_276 * sqrt(fract(_362.y + _361)), vec2(fma(_365, _332, -(_366 * _333)), fma(_365, _333, _366 * _332)), _373)) + vec2(0.5), vec2(0.5), _285);
        float _394 = _263.z;
        float _399 = -fma(parameters.gBias.y, _111, parameters.gBias.x);
        vec2 _403 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _405 = 6.283185482025146484375 * _403.x;
        float _406 = cos(_405);
        float _407 = sin(_405);
        vec2 _422 = clamp(floor(fma(_276 * sqrt(fract(_403.y + _361)), vec2(fma(_406, _332, -(_407 * _333)), fma(_406, _333, _407 * _332)), _373)) + vec2(0.5), vec2(0.5), _285);
        vec2 _439 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _441 = 6.283185482025146484375 * _439.x;
        float _442 = cos(_441);
        float _443 = sin(_441);
        vec2 _458 = clamp(floor(fma(_276 * sqrt(fract(_439.y + _361)), vec2(fma(_442, _332, -(_443 * _333)), fma(_442, _333, _443 * _332)), _373)) + vec2(0.5), vec2(0.5), _285);
        vec2 _475 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _477 = 6.283185482025146484375 * _475.x;
        float _478 = cos(_477);
        float _479 = sin(_477);
        vec2 _494 = clamp(floor(fma(_276 * sqrt(fract(_475.y + _361)), vec2(fma(_478, _332, -(_479 * _333)), fma(_478, _333, _479 * _332)), _373)) + vec2(0.5), vec2(0.5), _285);
        float _518 = -(((float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _382.x), _382.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _264, min(_394 + dot(_268, _382 - _373), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _422.x), _422.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _264, min(_394 + dot(_268, _422 - _373), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _458.x), _458.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _264, min(_394 + dot(_268, _458 - _373), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _494.x), _494.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _264, min(_394 + dot(_268, _494 - _373), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_111 < 65504.0) ? ((all(lessThanEqual(abs((_373 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_111 <= parameters.gCascadeFar.y)) ? fma(_518, 0.25, 1.0) : 1.0) : 1.0, _111, 0.0, 0.0));
        break;
    } while(false);
}

