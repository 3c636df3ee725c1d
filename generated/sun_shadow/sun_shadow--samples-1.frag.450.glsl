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
    vec2 _79 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _83 = parameters.gOutputSize.zw * 0.5;
    vec4 _86 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_83));
    vec4 _89 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _83));
    float _90 = _86.y;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    float _94 = _86.x;
    float _97 = (_94 > 0.0) ? min(_94, 65504.0) : 65504.0;
    float _98 = _86.z;
    float _101 = (_98 > 0.0) ? min(_98, 65504.0) : 65504.0;
    float _102 = _89.z;
    float _105 = (_102 > 0.0) ? min(_102, 65504.0) : 65504.0;
    float _106 = _89.x;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    vec3 _113 = vec3(_79 * _93, _93);
    bvec2 _135 = greaterThan(_79, parameters.gOutputSize.zw);
    bvec2 _137 = lessThan(_79, vec2(1.0) - parameters.gOutputSize.zw);
    float _143 = _105 - _93;
    vec2 _151 = mix(vec2(_143, _105), vec2(_93 - _97, _97), bvec2((_135.x ? abs(_97 - _93) : 131008.0) < (_137.x ? abs(_143) : 65504.0)));
    float _157 = _109 - _93;
    vec2 _165 = mix(vec2(_157, _109), vec2(_93 - _101, _101), bvec2((_135.y ? abs(_101 - _93) : 131008.0) < (_137.y ? abs(_157) : 65504.0)));
    float _169 = _151.x;
    vec3 _176 = vec3((_79 * _169) + (vec2(parameters.gOutputSize.z, 0.0) * _151.y), _169);
    float _184 = _165.x;
    vec3 _191 = vec3((_79 * _184) + (vec2(0.0, parameters.gOutputSize.w) * _165.y), _184);
    vec3 _196 = cross(vec3(dot(parameters.gToShadowX.xyz, _176), dot(parameters.gToShadowY.xyz, _176), dot(parameters.gToShadowZ.xyz, _176)), vec3(dot(parameters.gToShadowX.xyz, _191), dot(parameters.gToShadowY.xyz, _191), dot(parameters.gToShadowZ.xyz, _191)));
    float _197 = _196.z;
    bool _221 = _93 > parameters.gCascadeFar.x;
    bvec3 _222 = bvec3(_221);
    bool _234 = _93 > parameters.gCascadeFar.y;
    bvec3 _235 = bvec3(_234);
    vec3 _236 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _222), parameters.gCascadeScale2.xyz, _235);
    vec3 _240 = fma(vec3(dot(parameters.gToShadowX.xyz, _113), dot(parameters.gToShadowY.xyz, _113), dot(parameters.gToShadowZ.xyz, _113)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _236, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _222), parameters.gCascadeOffset2.xyz, _235));
    float _241 = _236.z;
    vec2 _242 = _236.xy;
    vec2 _265 = floor(gl_FragCoord.xy);
    vec2 _267 = floor(_265 * 0.5);
    vec2 _269 = _265 - (_267 * 2.0);
    vec2 _273 = _267 - (floor(_267 * 0.5) * 2.0);
    float _274 = _269.x;
    float _275 = _269.y;
    float _277 = abs(_274 - _275);
    float _278 = _273.y;
    float _283 = _273.x;
    vec2 _295 = vec2(fma(2.0, abs(_283 - _278), fma(8.0, _277, 4.0 * _275)) + _278, fma(2.0, abs(abs(_278 - _275) - _283), fma(4.0, _274, fma(-8.0, _277, 8.0))) + _283) * vec2(0.0625);
    float _300 = floor(parameters.gSubsetCount);
    float _303 = (_300 > 1.0) ? min(_300, 16.0) : 1.0;
    float _307 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _313 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_303, floor((_307 + 0.5) / _303), _307);
    float _317 = 6.283185482025146484375 * (_313.x + _295.x);
    float _318 = cos(_317);
    float _319 = sin(_317);
    vec2 _323 = fract(vec2(0.5));
    float _325 = 6.283185482025146484375 * _323.x;
    float _326 = cos(_325);
    float _327 = sin(_325);
    vec2 _334 = _240.xy;
    vec2 _343 = clamp(floor(fma(max(parameters.gDisc.xy * _242, vec2(parameters.gDisc.z)) * sqrt(fract(_323.y + (_313.y + _295.y))), vec2(fma(_326, _318, -(_327 * _319)), fma(_326, _319, _327 * _318)), _334)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _374 = (_93 < 65504.0) ? ((all(lessThanEqual(abs((_334 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_93 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_221) + float(_234), parameters.gCascadeSize.x, _343.x), _343.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gShadowBias.y, _93, parameters.gShadowBias.x), _241, min(_240.z + dot(clamp((-_196.xy) / vec2((abs(_197) > 9.9999996826552253889678874634872e-21) ? _197 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_241) / _242), _343 - _334), 1.0)))) : 1.0) : 1.0;
    gOutShadow = vec4(_374, _93, 0.0, 0.0);
}

