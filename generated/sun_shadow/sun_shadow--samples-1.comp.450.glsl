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
        vec2 _90 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _92 = _90 * parameters.gOutputSize.zw;
        vec2 _96 = parameters.gOutputSize.zw * 0.5;
        vec4 _99 = textureGather(gInCoarseDepth, fma(_90, parameters.gOutputSize.zw, -_96));
        vec4 _102 = textureGather(gInCoarseDepth, fma(_90, parameters.gOutputSize.zw, _96));
        float _103 = _99.y;
        float _106 = (_103 > 0.0) ? min(_103, 65504.0) : 65504.0;
        float _107 = _99.x;
        float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
        float _111 = _99.z;
        float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
        float _115 = _102.z;
        float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
        float _119 = _102.x;
        float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
        vec3 _126 = vec3(_92 * _106, _106);
        bvec2 _148 = greaterThan(_92, parameters.gOutputSize.zw);
        bvec2 _150 = lessThan(_92, vec2(1.0) - parameters.gOutputSize.zw);
        float _156 = _118 - _106;
        vec2 _164 = mix(vec2(_156, _118), vec2(_106 - _110, _110), bvec2((_148.x ? abs(_110 - _106) : 131008.0) < (_150.x ? abs(_156) : 65504.0)));
        float _170 = _122 - _106;
        vec2 _178 = mix(vec2(_170, _122), vec2(_106 - _114, _114), bvec2((_148.y ? abs(_114 - _106) : 131008.0) < (_150.y ? abs(_170) : 65504.0)));
        float _182 = _164.x;
        vec3 _189 = vec3((_92 * _182) + (vec2(parameters.gOutputSize.z, 0.0) * _164.y), _182);
        float _197 = _178.x;
        vec3 _204 = vec3((_92 * _197) + (vec2(0.0, parameters.gOutputSize.w) * _178.y), _197);
        vec3 _209 = cross(vec3(dot(parameters.gToShadowX.xyz, _189), dot(parameters.gToShadowY.xyz, _189), dot(parameters.gToShadowZ.xyz, _189)), vec3(dot(parameters.gToShadowX.xyz, _204), dot(parameters.gToShadowY.xyz, _204), dot(parameters.gToShadowZ.xyz, _204)));
        float _210 = _209.z;
        bool _234 = _106 > parameters.gCascadeFar.x;
        bvec3 _235 = bvec3(_234);
        bool _247 = _106 > parameters.gCascadeFar.y;
        bvec3 _248 = bvec3(_247);
        vec3 _249 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _235), parameters.gCascadeScale2.xyz, _248);
        vec3 _253 = fma(vec3(dot(parameters.gToShadowX.xyz, _126), dot(parameters.gToShadowY.xyz, _126), dot(parameters.gToShadowZ.xyz, _126)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _249, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _235), parameters.gCascadeOffset2.xyz, _248));
        float _254 = _249.z;
        vec2 _255 = _249.xy;
        vec2 _278 = floor(_90);
        vec2 _280 = floor(_278 * 0.5);
        vec2 _282 = _278 - (_280 * 2.0);
        vec2 _286 = _280 - (floor(_280 * 0.5) * 2.0);
        float _287 = _282.x;
        float _288 = _282.y;
        float _290 = abs(_287 - _288);
        float _291 = _286.y;
        float _296 = _286.x;
        vec2 _308 = vec2(fma(2.0, abs(_296 - _291), fma(8.0, _290, 4.0 * _288)) + _291, fma(2.0, abs(abs(_291 - _288) - _296), fma(4.0, _287, fma(-8.0, _290, 8.0))) + _296) * vec2(0.0625);
        float _313 = floor(parameters.gSubsetCount);
        float _316 = (_313 > 1.0) ? min(_313, 16.0) : 1.0;
        float _320 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _326 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_316, floor((_320 + 0.5) / _316), _320);
        float _330 = 6.283185482025146484375 * (_326.x + _308.x);
        float _331 = cos(_330);
        float _332 = sin(_330);
        vec2 _336 = fract(vec2(0.5));
        float _338 = 6.283185482025146484375 * _336.x;
        float _339 = cos(_338);
        float _340 = sin(_338);
        vec2 _356 = clamp(floor(fma(max(parameters.gDisc.xy * _255, vec2(parameters.gDisc.z)) * sqrt(fract(_336.y + (_326.y + _308.y))), vec2(fma(_339, _331, -(_340 * _332)), fma(_339, _332, _340 * _331)), _253.xy)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
        float _387 = (_106 < 65504.0) ? ((all(lessThanEqual(abs((_253.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_106 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_234) + float(_247), parameters.gCascadeSize.x, _356.x), _356.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gShadowBias.y, _106, parameters.gShadowBias.x), _254, min(_253.z + dot(clamp((-_209.xy) / vec2((abs(_210) > 9.9999996826552253889678874634872e-21) ? _210 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_254) / _255), _356 - _253.xy), 1.0)))) : 1.0) : 1.0;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_387, _106, 0.0, 0.0));
        break;
    } while(false);
}

