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
    vec2 _80 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _84 = _80 * parameters.gOutputSize.zw;
    vec2 _88 = parameters.gOutputSize.zw * 0.5;
    vec4 _91 = textureGather(gInCoarseDepth, fma(_80, parameters.gOutputSize.zw, -_88));
    vec4 _94 = textureGather(gInCoarseDepth, fma(_80, parameters.gOutputSize.zw, _88));
    float _95 = _91.y;
    float _98 = (_95 > 0.0) ? min(_95, 65504.0) : 65504.0;
    float _99 = _91.x;
    float _102 = (_99 > 0.0) ? min(_99, 65504.0) : 65504.0;
    float _103 = _91.z;
    float _106 = (_103 > 0.0) ? min(_103, 65504.0) : 65504.0;
    float _107 = _94.z;
    float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
    float _111 = _94.x;
    float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
    vec3 _118 = vec3(_84 * _98, _98);
    bvec2 _140 = greaterThan(_84, parameters.gOutputSize.zw);
    bvec2 _142 = lessThan(_84, vec2(1.0) - parameters.gOutputSize.zw);
    float _148 = _110 - _98;
    vec2 _156 = mix(vec2(_148, _110), vec2(_98 - _102, _102), bvec2((_140.x ? abs(_102 - _98) : 131008.0) < (_142.x ? abs(_148) : 65504.0)));
    float _162 = _114 - _98;
    vec2 _170 = mix(vec2(_162, _114), vec2(_98 - _106, _106), bvec2((_140.y ? abs(_106 - _98) : 131008.0) < (_142.y ? abs(_162) : 65504.0)));
    float _174 = _156.x;
    vec3 _181 = vec3((_84 * _174) + (vec2(parameters.gOutputSize.z, 0.0) * _156.y), _174);
    float _189 = _170.x;
    vec3 _196 = vec3((_84 * _189) + (vec2(0.0, parameters.gOutputSize.w) * _170.y), _189);
    vec3 _201 = cross(vec3(dot(parameters.gToShadowX.xyz, _181), dot(parameters.gToShadowY.xyz, _181), dot(parameters.gToShadowZ.xyz, _181)), vec3(dot(parameters.gToShadowX.xyz, _196), dot(parameters.gToShadowY.xyz, _196), dot(parameters.gToShadowZ.xyz, _196)));
    float _202 = _201.z;
    bool _226 = _98 > parameters.gCascadeFar.x;
    bvec3 _227 = bvec3(_226);
    bool _239 = _98 > parameters.gCascadeFar.y;
    bvec3 _240 = bvec3(_239);
    vec3 _241 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _227), parameters.gCascadeScale2.xyz, _240);
    vec3 _245 = fma(vec3(dot(parameters.gToShadowX.xyz, _118), dot(parameters.gToShadowY.xyz, _118), dot(parameters.gToShadowZ.xyz, _118)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _241, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _227), parameters.gCascadeOffset2.xyz, _240));
    float _246 = _241.z;
    vec2 _247 = _241.xy;
    vec2 _270 = floor(_80);
    vec2 _272 = floor(_270 * 0.5);
    vec2 _274 = _270 - (_272 * 2.0);
    vec2 _278 = _272 - (floor(_272 * 0.5) * 2.0);
    float _279 = _274.x;
    float _280 = _274.y;
    float _282 = abs(_279 - _280);
    float _283 = _278.y;
    float _288 = _278.x;
    vec2 _300 = vec2(fma(2.0, abs(_288 - _283), fma(8.0, _282, 4.0 * _280)) + _283, fma(2.0, abs(abs(_283 - _280) - _288), fma(4.0, _279, fma(-8.0, _282, 8.0))) + _288) * vec2(0.0625);
    float _305 = floor(parameters.gSubsetCount);
    float _308 = (_305 > 1.0) ? min(_305, 16.0) : 1.0;
    float _312 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _318 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_308, floor((_312 + 0.5) / _308), _312);
    float _322 = 6.283185482025146484375 * (_318.x + _300.x);
    float _323 = cos(_322);
    float _324 = sin(_322);
    vec2 _328 = fract(vec2(0.5));
    float _330 = 6.283185482025146484375 * _328.x;
    float _331 = cos(_330);
    float _332 = sin(_330);
    vec2 _348 = clamp(floor(fma(max(parameters.gDisc.xy * _247, vec2(parameters.gDisc.z)) * sqrt(fract(_328.y + (_318.y + _300.y))), vec2(fma(_331, _323, -(_332 * _324)), fma(_331, _324, _332 * _323)), _245.xy)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _379 = (_98 < 65504.0) ? ((all(lessThanEqual(abs((_245.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_98 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_226) + float(_239), parameters.gCascadeSize.x, _348.x), _348.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gShadowBias.y, _98, parameters.gShadowBias.x), _246, min(_245.z + dot(clamp((-_201.xy) / vec2((abs(_202) > 9.9999996826552253889678874634872e-21) ? _202 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_246) / _247), _348 - _245.xy), 1.0)))) : 1.0) : 1.0;
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_379, _98, 0.0, 0.0));
}

