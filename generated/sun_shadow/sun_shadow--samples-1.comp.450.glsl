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
        vec2 _87 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _89 = _87 * parameters.gOutputSize.zw;
        vec2 _93 = parameters.gOutputSize.zw * 0.5;
        vec4 _96 = textureGather(gInCoarseDepth, fma(_87, parameters.gOutputSize.zw, -_93));
        vec4 _99 = textureGather(gInCoarseDepth, fma(_87, parameters.gOutputSize.zw, _93));
        float _100 = _96.y;
        float _102 = (_100 > 0.0) ? _100 : 65504.0;
        float _104 = (_102 < 65504.0) ? _102 : 65504.0;
        float _105 = _96.x;
        float _107 = (_105 > 0.0) ? _105 : 65504.0;
        float _109 = (_107 < 65504.0) ? _107 : 65504.0;
        float _110 = _96.z;
        float _112 = (_110 > 0.0) ? _110 : 65504.0;
        float _114 = (_112 < 65504.0) ? _112 : 65504.0;
        float _115 = _99.z;
        float _117 = (_115 > 0.0) ? _115 : 65504.0;
        float _119 = (_117 < 65504.0) ? _117 : 65504.0;
        float _120 = _99.x;
        float _122 = (_120 > 0.0) ? _120 : 65504.0;
        float _124 = (_122 < 65504.0) ? _122 : 65504.0;
        vec3 _128 = vec3(_89 * _104, _104);
        vec2 _152 = vec2(parameters.gOutputSize.z, 0.0);
        float _167 = _119 - _104;
        vec2 _175 = mix(vec2(_167, _119), vec2(_104 - _109, _109), bvec2((all(lessThanEqual(abs(fma(_87, parameters.gOutputSize.zw, -_152) - vec2(0.5)), vec2(0.5))) ? abs(_109 - _104) : 131008.0) < (all(lessThanEqual(abs(fma(_87, parameters.gOutputSize.zw, _152) - vec2(0.5)), vec2(0.5))) ? abs(_167) : 65504.0)));
        float _176 = _175.x;
        vec3 _183 = vec3((_89 * _176) + (_152 * _175.y), _176);
        vec2 _190 = vec2(0.0, parameters.gOutputSize.w);
        float _205 = _124 - _104;
        vec2 _213 = mix(vec2(_205, _124), vec2(_104 - _114, _114), bvec2((all(lessThanEqual(abs(fma(_87, parameters.gOutputSize.zw, -_190) - vec2(0.5)), vec2(0.5))) ? abs(_114 - _104) : 131008.0) < (all(lessThanEqual(abs(fma(_87, parameters.gOutputSize.zw, _190) - vec2(0.5)), vec2(0.5))) ? abs(_205) : 65504.0)));
        float _214 = _213.x;
        vec3 _221 = vec3((_89 * _214) + (_190 * _213.y), _214);
        vec3 _226 = cross(vec3(dot(parameters.gToShadowX.xyz, _183), dot(parameters.gToShadowY.xyz, _183), dot(parameters.gToShadowZ.xyz, _183)), vec3(dot(parameters.gToShadowX.xyz, _221), dot(parameters.gToShadowY.xyz, _221), dot(parameters.gToShadowZ.xyz, _221)));
        float _227 = _226.z;
        bool _251 = _104 > parameters.gCascadeFar.x;
        bvec3 _252 = bvec3(_251);
        bool _264 = _104 > parameters.gCascadeFar.y;
        bvec3 _265 = bvec3(_264);
        vec3 _266 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _252), parameters.gCascadeScale2.xyz, _265);
        vec3 _270 = fma(vec3(dot(parameters.gToShadowX.xyz, _128), dot(parameters.gToShadowY.xyz, _128), dot(parameters.gToShadowZ.xyz, _128)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _266, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _252), parameters.gCascadeOffset2.xyz, _265));
        float _271 = _266.z;
        vec2 _272 = _266.xy;
        vec2 _295 = floor(_87);
        float _300 = floor(parameters.gSubsetCount);
        float _303 = (_300 > 1.0) ? min(_300, 16.0) : 1.0;
        float _307 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _313 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_303, floor((_307 + 0.5) / _303), _307);
        vec2 _316 = floor(_295 * 0.5);
        vec2 _318 = _295 - (_316 * 2.0);
        vec2 _322 = _316 - (floor(_295 * 0.25) * 2.0);
        float _324 = _318.y;
        float _327 = _322.y;
        vec2 _333 = (abs(vec2(_318.x - _324, _322.x - _327)) * 2.0) + vec2(_324, _327);
        float _338 = 6.283185482025146484375 * fma(fma(4.0, _333.x, _333.y), 0.0625, _313.x);
        float _339 = cos(_338);
        float _340 = sin(_338);
        vec2 _345 = vec2(_295.y + 1.0, _295.x);
        vec2 _347 = floor(_345 * 0.5);
        vec2 _349 = _345 - (_347 * 2.0);
        vec2 _353 = _347 - (floor(_345 * 0.25) * 2.0);
        float _355 = _349.y;
        float _358 = _353.y;
        vec2 _364 = (abs(vec2(_349.x - _355, _353.x - _358)) * 2.0) + vec2(_355, _358);
        vec2 _369 = fract(vec2(0.5));
        float _371 = 6.283185482025146484375 * _369.x;
        float _372 = cos(_371);
        float _373 = sin(_371);
        vec2 _389 = clamp(floor(fma(max(parameters.gDisc.xy * _272, vec2(parameters.gDisc.z)) * sqrt(fract(_369.y + fma(fma(4.0, _364.x, _364.y), 0.0625, _313.y))), vec2(fma(_372, _339, -(_373 * _340)), fma(_372, _340, _373 * _339)), _270.xy)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
        float _420 = (_104 < 65504.0) ? ((all(lessThanEqual(abs((_270.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_104 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_251) + float(_264), parameters.gCascadeSize.x, _389.x), _389.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gBias.y, _104, parameters.gBias.x), _271, min(_270.z + dot(clamp((-_226.xy) / vec2((abs(_227) > 9.9999996826552253889678874634872e-21) ? _227 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_271) / _272), _389 - _270.xy), 1.0)))) : 1.0) : 1.0;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_420, _104, 0.0, 0.0));
        break;
    } while(false);
}

