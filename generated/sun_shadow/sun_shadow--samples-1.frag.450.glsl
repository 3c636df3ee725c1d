#version 450

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

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _86 = parameters.gOutputSize.zw * 0.5;
    vec4 _89 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_86));
    vec4 _92 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _86));
    float _93 = _89.y;
    float _96 = (_93 > 0.0) ? min(_93, 65504.0) : 65504.0;
    float _97 = _89.x;
    float _100 = (_97 > 0.0) ? min(_97, 65504.0) : 65504.0;
    float _101 = _89.z;
    float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
    float _105 = _92.z;
    float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
    float _109 = _92.x;
    float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
    vec3 _116 = vec3(_82 * _96, _96);
    bvec2 _138 = greaterThan(_82, parameters.gOutputSize.zw);
    bvec2 _140 = lessThan(_82, vec2(1.0) - parameters.gOutputSize.zw);
    float _146 = _108 - _96;
    vec2 _154 = mix(vec2(_146, _108), vec2(_96 - _100, _100), bvec2((_138.x ? abs(_100 - _96) : 131008.0) < (_140.x ? abs(_146) : 65504.0)));
    float _160 = _112 - _96;
    vec2 _168 = mix(vec2(_160, _112), vec2(_96 - _104, _104), bvec2((_138.y ? abs(_104 - _96) : 131008.0) < (_140.y ? abs(_160) : 65504.0)));
    float _172 = _154.x;
    vec3 _179 = vec3((_82 * _172) + (vec2(parameters.gOutputSize.z, 0.0) * _154.y), _172);
    float _187 = _168.x;
    vec3 _194 = vec3((_82 * _187) + (vec2(0.0, parameters.gOutputSize.w) * _168.y), _187);
    vec3 _199 = cross(vec3(dot(parameters.gToShadowX.xyz, _179), dot(parameters.gToShadowY.xyz, _179), dot(parameters.gToShadowZ.xyz, _179)), vec3(dot(parameters.gToShadowX.xyz, _194), dot(parameters.gToShadowY.xyz, _194), dot(parameters.gToShadowZ.xyz, _194)));
    float _200 = _199.z;
    bool _224 = _96 > parameters.gCascadeFar.x;
    bvec3 _225 = bvec3(_224);
    bool _237 = _96 > parameters.gCascadeFar.y;
    bvec3 _238 = bvec3(_237);
    vec3 _239 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _225), parameters.gCascadeScale2.xyz, _238);
    vec3 _243 = fma(vec3(dot(parameters.gToShadowX.xyz, _116), dot(parameters.gToShadowY.xyz, _116), dot(parameters.gToShadowZ.xyz, _116)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _239, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _225), parameters.gCascadeOffset2.xyz, _238));
    float _244 = _239.z;
    vec2 _245 = _239.xy;
    vec2 _268 = floor(gl_FragCoord.xy);
    vec2 _270 = floor(_268 * 0.5);
    vec2 _272 = _268 - (_270 * 2.0);
    vec2 _276 = _270 - (floor(_270 * 0.5) * 2.0);
    float _277 = _272.x;
    float _278 = _272.y;
    float _280 = abs(_277 - _278);
    float _281 = _276.y;
    float _286 = _276.x;
    vec2 _298 = vec2(fma(2.0, abs(_286 - _281), fma(8.0, _280, 4.0 * _278)) + _281, fma(2.0, abs(abs(_281 - _278) - _286), fma(4.0, _277, fma(-8.0, _280, 8.0))) + _286) * vec2(0.0625);
    float _303 = floor(parameters.gSubsetCount);
    float _306 = (_303 > 1.0) ? min(_303, 16.0) : 1.0;
    float _310 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _316 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_306, floor((_310 + 0.5) / _306), _310);
    float _320 = 6.283185482025146484375 * (_316.x + _298.x);
    float _321 = cos(_320);
    float _322 = sin(_320);
    vec2 _326 = fract(vec2(0.5));
    float _328 = 6.283185482025146484375 * _326.x;
    float _329 = cos(_328);
    float _330 = sin(_328);
    vec2 _337 = _243.xy;
    vec2 _346 = clamp(floor(fma(max(parameters.gDisc.xy * _245, vec2(parameters.gDisc.z)) * sqrt(fract(_326.y + (_316.y + _298.y))), vec2(fma(_329, _321, -(_330 * _322)), fma(_329, _322, _330 * _321)), _337)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _376 = (_96 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_337 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_96 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_224) + float(_237), parameters.gCascadeSize.x, _346.x), _346.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gShadowBias.y, _96, parameters.gShadowBias.x), _244, min(_243.z + dot(clamp((-_199.xy) / vec2((abs(_200) > 9.9999996826552253889678874634872e-21) ? _200 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_244) / _245), _346 - _337), 1.0)))) : 1.0) : 1.0;
    gOutShadow = vec4(_376, _96, 0.0, 0.0);
}

