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
    vec2 _82 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _86 = _82 * parameters.gOutputSize.zw;
    vec2 _90 = parameters.gOutputSize.zw * 0.5;
    vec4 _93 = textureGather(gInCoarseDepth, fma(_82, parameters.gOutputSize.zw, -_90));
    vec4 _96 = textureGather(gInCoarseDepth, fma(_82, parameters.gOutputSize.zw, _90));
    float _97 = _93.y;
    float _100 = (_97 > 0.0) ? min(_97, 65504.0) : 65504.0;
    float _101 = _93.x;
    float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
    float _105 = _93.z;
    float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
    float _109 = _96.z;
    float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
    float _113 = _96.x;
    float _116 = (_113 > 0.0) ? min(_113, 65504.0) : 65504.0;
    vec3 _120 = vec3(_86 * _100, _100);
    bvec2 _142 = greaterThan(_86, parameters.gOutputSize.zw);
    bvec2 _144 = lessThan(_86, vec2(1.0) - parameters.gOutputSize.zw);
    float _150 = _112 - _100;
    vec2 _158 = mix(vec2(_150, _112), vec2(_100 - _104, _104), bvec2((_142.x ? abs(_104 - _100) : 131008.0) < (_144.x ? abs(_150) : 65504.0)));
    float _164 = _116 - _100;
    vec2 _172 = mix(vec2(_164, _116), vec2(_100 - _108, _108), bvec2((_142.y ? abs(_108 - _100) : 131008.0) < (_144.y ? abs(_164) : 65504.0)));
    float _176 = _158.x;
    vec3 _183 = vec3((_86 * _176) + (vec2(parameters.gOutputSize.z, 0.0) * _158.y), _176);
    float _191 = _172.x;
    vec3 _198 = vec3((_86 * _191) + (vec2(0.0, parameters.gOutputSize.w) * _172.y), _191);
    vec3 _203 = cross(vec3(dot(parameters.gToShadowX.xyz, _183), dot(parameters.gToShadowY.xyz, _183), dot(parameters.gToShadowZ.xyz, _183)), vec3(dot(parameters.gToShadowX.xyz, _198), dot(parameters.gToShadowY.xyz, _198), dot(parameters.gToShadowZ.xyz, _198)));
    float _204 = _203.z;
    bool _228 = _100 > parameters.gCascadeFar.x;
    bvec3 _229 = bvec3(_228);
    bool _241 = _100 > parameters.gCascadeFar.y;
    bvec3 _242 = bvec3(_241);
    vec3 _243 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _229), parameters.gCascadeScale2.xyz, _242);
    vec3 _247 = fma(vec3(dot(parameters.gToShadowX.xyz, _120), dot(parameters.gToShadowY.xyz, _120), dot(parameters.gToShadowZ.xyz, _120)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _243, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _229), parameters.gCascadeOffset2.xyz, _242));
    float _248 = _243.z;
    vec2 _249 = _243.xy;
    vec2 _272 = floor(_82);
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
    vec2 _320 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_310, floor((_314 + 0.5) / _310), _314);
    float _324 = 6.283185482025146484375 * (_320.x + _302.x);
    float _325 = cos(_324);
    float _326 = sin(_324);
    vec2 _330 = fract(vec2(0.5));
    float _332 = 6.283185482025146484375 * _330.x;
    float _333 = cos(_332);
    float _334 = sin(_332);
    vec2 _350 = clamp(floor(fma(max(parameters.gDisc.xy * _249, vec2(parameters.gDisc.z)) * sqrt(fract(_330.y + (_320.y + _302.y))), vec2(fma(_333, _325, -(_334 * _326)), fma(_333, _326, _334 * _325)), _247.xy)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _380 = (_100 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_247.xy / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_100 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_228) + float(_241), parameters.gCascadeSize.x, _350.x), _350.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gShadowBias.y, _100, parameters.gShadowBias.x), _248, min(_247.z + dot(clamp((-_203.xy) / vec2((abs(_204) > 9.9999996826552253889678874634872e-21) ? _204 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_248) / _249), _350 - _247.xy), 1.0)))) : 1.0) : 1.0;
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_380, _100, 0.0, 0.0));
}

