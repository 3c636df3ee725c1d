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
        vec2 _90 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _92 = _90 * parameters.gOutputSize.zw;
        vec2 _96 = parameters.gOutputSize.zw * 0.5;
        vec4 _99 = textureGather(gInCoarseDepth, fma(_90, parameters.gOutputSize.zw, -_96));
        vec4 _102 = textureGather(gInCoarseDepth, fma(_90, parameters.gOutputSize.zw, _96));
        float _103 = _99.y;
        float _105 = (_103 > 0.0) ? _103 : 65504.0;
        float _107 = (_105 < 65504.0) ? _105 : 65504.0;
        float _108 = _99.x;
        float _110 = (_108 > 0.0) ? _108 : 65504.0;
        float _112 = (_110 < 65504.0) ? _110 : 65504.0;
        float _113 = _99.z;
        float _115 = (_113 > 0.0) ? _113 : 65504.0;
        float _117 = (_115 < 65504.0) ? _115 : 65504.0;
        float _118 = _102.z;
        float _120 = (_118 > 0.0) ? _118 : 65504.0;
        float _122 = (_120 < 65504.0) ? _120 : 65504.0;
        float _123 = _102.x;
        float _125 = (_123 > 0.0) ? _123 : 65504.0;
        float _127 = (_125 < 65504.0) ? _125 : 65504.0;
        vec3 _131 = vec3(_92 * _107, _107);
        vec2 _155 = vec2(parameters.gOutputSize.z, 0.0);
        float _170 = _122 - _107;
        vec2 _178 = mix(vec2(_170, _122), vec2(_107 - _112, _112), bvec2((all(lessThanEqual(abs(fma(_90, parameters.gOutputSize.zw, -_155) - vec2(0.5)), vec2(0.5))) ? abs(_112 - _107) : 131008.0) < (all(lessThanEqual(abs(fma(_90, parameters.gOutputSize.zw, _155) - vec2(0.5)), vec2(0.5))) ? abs(_170) : 65504.0)));
        float _179 = _178.x;
        vec3 _186 = vec3((_92 * _179) + (_155 * _178.y), _179);
        vec2 _193 = vec2(0.0, parameters.gOutputSize.w);
        float _208 = _127 - _107;
        vec2 _216 = mix(vec2(_208, _127), vec2(_107 - _117, _117), bvec2((all(lessThanEqual(abs(fma(_90, parameters.gOutputSize.zw, -_193) - vec2(0.5)), vec2(0.5))) ? abs(_117 - _107) : 131008.0) < (all(lessThanEqual(abs(fma(_90, parameters.gOutputSize.zw, _193) - vec2(0.5)), vec2(0.5))) ? abs(_208) : 65504.0)));
        float _217 = _216.x;
        vec3 _224 = vec3((_92 * _217) + (_193 * _216.y), _217);
        vec3 _229 = cross(vec3(dot(parameters.gToShadowX.xyz, _186), dot(parameters.gToShadowY.xyz, _186), dot(parameters.gToShadowZ.xyz, _186)), vec3(dot(parameters.gToShadowX.xyz, _224), dot(parameters.gToShadowY.xyz, _224), dot(parameters.gToShadowZ.xyz, _224)));
        float _230 = _229.z;
        bool _254 = _107 > parameters.gCascadeFar.x;
        bvec3 _255 = bvec3(_254);
        bool _267 = _107 > parameters.gCascadeFar.y;
        bvec3 _268 = bvec3(_267);
        vec3 _269 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _255), parameters.gCascadeScale2.xyz, _268);
        float _272 = float(_254) + float(_267);
        vec3 _273 = fma(vec3(dot(parameters.gToShadowX.xyz, _131), dot(parameters.gToShadowY.xyz, _131), dot(parameters.gToShadowZ.xyz, _131)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _269, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _255), parameters.gCascadeOffset2.xyz, _268));
        float _274 = _269.z;
        vec2 _275 = _269.xy;
        vec2 _278 = clamp((-_229.xy) / vec2((abs(_230) > 9.9999996826552253889678874634872e-21) ? _230 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_274) / _275);
        vec2 _286 = max(parameters.gDisc.xy * _275, vec2(parameters.gDisc.z));
        vec2 _295 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _298 = floor(_90);
        float _303 = floor(parameters.gSubsetCount);
        float _306 = (_303 > 1.0) ? min(_303, 16.0) : 1.0;
        float _310 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _316 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * fma(-_306, floor((_310 + 0.5) / _306), _310);
        vec2 _319 = floor(_298 * 0.5);
        vec2 _321 = _298 - (_319 * 2.0);
        vec2 _325 = _319 - (floor(_298 * 0.25) * 2.0);
        float _327 = _321.y;
        float _330 = _325.y;
        vec2 _336 = (abs(vec2(_321.x - _327, _325.x - _330)) * 2.0) + vec2(_327, _330);
        float _341 = 6.283185482025146484375 * fma(fma(4.0, _336.x, _336.y), 0.0625, _316.x);
        float _342 = cos(_341);
        float _343 = sin(_341);
        vec2 _348 = vec2(_298.y + 1.0, _298.x);
        vec2 _350 = floor(_348 * 0.5);
        vec2 _352 = _348 - (_350 * 2.0);
        vec2 _356 = _350 - (floor(_348 * 0.25) * 2.0);
        float _358 = _352.y;
        float _361 = _356.y;
        vec2 _367 = (abs(vec2(_352.x - _358, _356.x - _361)) * 2.0) + vec2(_358, _361);
        float _371 = fma(fma(4.0, _367.x, _367.y), 0.0625, _316.y);
        vec2 _372 = fract(vec2(0.5));
        float _374 = 6.283185482025146484375 * _372.x;
        float _375 = cos(_374);
        float _376 = sin(_374);
        vec2 _392 = clamp(floor(fma(_286 * sqrt(fract(_372.y + _371)), vec2(fma(_375, _342, -(_376 * _343)), fma(_375, _343, _376 * _342)), _273.xy)) + vec2(0.5), vec2(0.5), _295);
        float _409 = -fma(parameters.gBias.y, _107, parameters.gBias.x);
        vec2 _413 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _415 = 6.283185482025146484375 * _413.x;
        float _416 = cos(_415);
        float _417 = sin(_415);
        vec2 _432 = clamp(floor(fma(_286 * sqrt(fract(_413.y + _371)), vec2(fma(_416, _342, -(_417 * _343)), fma(_416, _343, _417 * _342)), _273.xy)) + vec2(0.5), vec2(0.5), _295);
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_107 < 65504.0) ? ((all(lessThanEqual(abs((_273.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_107 <= parameters.gCascadeFar.z)) ? fma(-(float(textureLod(gInShadowMap, vec2(fma(_272, parameters.gCascadeSize.x, _392.x), _392.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_409, _274, min(_273.z + dot(_278, _392 - _273.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_272, parameters.gCascadeSize.x, _432.x), _432.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_409, _274, min(_273.z + dot(_278, _432 - _273.xy), 1.0)))), 0.5, 1.0) : 1.0) : 1.0, _107, 0.0, 0.0));
        break;
    } while(false);
}

