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
        vec2 _93 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _95 = _93 * parameters.gOutputSize.zw;
        vec2 _99 = parameters.gOutputSize.zw * 0.5;
        vec4 _102 = textureGather(gInCoarseDepth, fma(_93, parameters.gOutputSize.zw, -_99));
        vec4 _105 = textureGather(gInCoarseDepth, fma(_93, parameters.gOutputSize.zw, _99));
        float _106 = _102.y;
        float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
        float _110 = _102.x;
        float _113 = (_110 > 0.0) ? min(_110, 65504.0) : 65504.0;
        float _114 = _102.z;
        float _117 = (_114 > 0.0) ? min(_114, 65504.0) : 65504.0;
        float _118 = _105.z;
        float _121 = (_118 > 0.0) ? min(_118, 65504.0) : 65504.0;
        float _122 = _105.x;
        float _125 = (_122 > 0.0) ? min(_122, 65504.0) : 65504.0;
        vec3 _129 = vec3(_95 * _109, _109);
        bvec2 _151 = greaterThan(_95, parameters.gOutputSize.zw);
        bvec2 _153 = lessThan(_95, vec2(1.0) - parameters.gOutputSize.zw);
        float _159 = _121 - _109;
        vec2 _167 = mix(vec2(_159, _121), vec2(_109 - _113, _113), bvec2((_151.x ? abs(_113 - _109) : 131008.0) < (_153.x ? abs(_159) : 65504.0)));
        float _173 = _125 - _109;
        vec2 _181 = mix(vec2(_173, _125), vec2(_109 - _117, _117), bvec2((_151.y ? abs(_117 - _109) : 131008.0) < (_153.y ? abs(_173) : 65504.0)));
        float _185 = _167.x;
        vec3 _192 = vec3((_95 * _185) + (vec2(parameters.gOutputSize.z, 0.0) * _167.y), _185);
        float _200 = _181.x;
        vec3 _207 = vec3((_95 * _200) + (vec2(0.0, parameters.gOutputSize.w) * _181.y), _200);
        vec3 _212 = cross(vec3(dot(parameters.gToShadowX.xyz, _192), dot(parameters.gToShadowY.xyz, _192), dot(parameters.gToShadowZ.xyz, _192)), vec3(dot(parameters.gToShadowX.xyz, _207), dot(parameters.gToShadowY.xyz, _207), dot(parameters.gToShadowZ.xyz, _207)));
        float _213 = _212.z;
        bool _237 = _109 > parameters.gCascadeFar.x;
        bvec3 _238 = bvec3(_237);
        bool _250 = _109 > parameters.gCascadeFar.y;
        bvec3 _251 = bvec3(_250);
        vec3 _252 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _238), parameters.gCascadeScale2.xyz, _251);
        float _255 = float(_237) + float(_250);
        vec3 _256 = fma(vec3(dot(parameters.gToShadowX.xyz, _129), dot(parameters.gToShadowY.xyz, _129), dot(parameters.gToShadowZ.xyz, _129)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _252, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _238), parameters.gCascadeOffset2.xyz, _251));
        float _257 = _252.z;
        vec2 _258 = _252.xy;
        vec2 _261 = clamp((-_212.xy) / vec2((abs(_213) > 9.9999996826552253889678874634872e-21) ? _213 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_257) / _258);
        vec2 _269 = max(parameters.gDisc.xy * _258, vec2(parameters.gDisc.z));
        vec2 _278 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _281 = floor(_93);
        vec2 _283 = floor(_281 * 0.5);
        vec2 _285 = _281 - (_283 * 2.0);
        vec2 _289 = _283 - (floor(_283 * 0.5) * 2.0);
        float _290 = _285.x;
        float _291 = _285.y;
        float _293 = abs(_290 - _291);
        float _294 = _289.y;
        float _299 = _289.x;
        vec2 _311 = vec2(fma(2.0, abs(_299 - _294), fma(8.0, _293, 4.0 * _291)) + _294, fma(2.0, abs(abs(_294 - _291) - _299), fma(4.0, _290, fma(-8.0, _293, 8.0))) + _299) * vec2(0.0625);
        float _316 = floor(parameters.gSubsetCount);
        float _319 = (_316 > 1.0) ? min(_316, 16.0) : 1.0;
        float _323 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _329 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * fma(-_319, floor((_323 + 0.5) / _319), _323);
        float _333 = 6.283185482025146484375 * (_329.x + _311.x);
        float _334 = cos(_333);
        float _335 = sin(_333);
        float _338 = _329.y + _311.y;
        vec2 _339 = fract(vec2(0.5));
        float _341 = 6.283185482025146484375 * _339.x;
        float _342 = cos(_341);
        float _343 = sin(_341);
        vec2 _359 = clamp(floor(fma(_269 * sqrt(fract(_339.y + _338)), vec2(fma(_342, _334, -(_343 * _335)), fma(_342, _335, _343 * _334)), _256.xy)) + vec2(0.5), vec2(0.5), _278);
        float _376 = -fma(parameters.gShadowBias.y, _109, parameters.gShadowBias.x);
        vec2 _380 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _382 = 6.283185482025146484375 * _380.x;
        float _383 = cos(_382);
        float _384 = sin(_382);
        vec2 _399 = clamp(floor(fma(_269 * sqrt(fract(_380.y + _338)), vec2(fma(_383, _334, -(_384 * _335)), fma(_383, _335, _384 * _334)), _256.xy)) + vec2(0.5), vec2(0.5), _278);
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_109 < 65504.0) ? ((all(lessThanEqual(abs((_256.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_109 <= parameters.gCascadeFar.z)) ? fma(-(float(textureLod(gInShadowMap, vec2(fma(_255, parameters.gCascadeSize.x, _359.x), _359.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_376, _257, min(_256.z + dot(_261, _359 - _256.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_255, parameters.gCascadeSize.x, _399.x), _399.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_376, _257, min(_256.z + dot(_261, _399 - _256.xy), 1.0)))), 0.5, 1.0) : 1.0) : 1.0, _109, 0.0, 0.0));
        break;
    } while(false);
}

