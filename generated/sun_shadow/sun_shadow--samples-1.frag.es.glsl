#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform SunShadowParameters
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

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _86 = textureLod(gInCoarseDepth, _82, 0.0);
    float _87 = _86.x;
    float _90 = (_87 > 0.0) ? min(_87, 65504.0) : 65504.0;
    vec2 _93 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _97 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_93), 0.0);
    float _98 = _97.x;
    float _101 = (_98 > 0.0) ? min(_98, 65504.0) : 65504.0;
    vec2 _104 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _108 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_104), 0.0);
    float _109 = _108.x;
    float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
    vec4 _115 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _93, 0.0);
    float _116 = _115.x;
    float _119 = (_116 > 0.0) ? min(_116, 65504.0) : 65504.0;
    vec4 _122 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _104, 0.0);
    float _123 = _122.x;
    float _126 = (_123 > 0.0) ? min(_123, 65504.0) : 65504.0;
    vec3 _130 = vec3(_82 * _90, _90);
    bvec2 _152 = greaterThan(_82, parameters.gOutputSize.zw);
    bvec2 _154 = lessThan(_82, vec2(1.0) - parameters.gOutputSize.zw);
    float _160 = _119 - _90;
    vec2 _165 = vec2(_90 - _101, _101);
    vec2 _166 = vec2(_160, _119);
    bvec2 _167 = bvec2((_152.x ? abs(_101 - _90) : 131008.0) < (_154.x ? abs(_160) : 65504.0));
    vec2 _168 = vec2(_167.x ? _165.x : _166.x, _167.y ? _165.y : _166.y);
    float _174 = _126 - _90;
    vec2 _179 = vec2(_90 - _112, _112);
    vec2 _180 = vec2(_174, _126);
    bvec2 _181 = bvec2((_152.y ? abs(_112 - _90) : 131008.0) < (_154.y ? abs(_174) : 65504.0));
    vec2 _182 = vec2(_181.x ? _179.x : _180.x, _181.y ? _179.y : _180.y);
    float _183 = _168.x;
    vec3 _190 = vec3((_82 * _183) + (_93 * _168.y), _183);
    float _195 = _182.x;
    vec3 _202 = vec3((_82 * _195) + (_104 * _182.y), _195);
    vec3 _207 = cross(vec3(dot(parameters.gToShadowX.xyz, _190), dot(parameters.gToShadowY.xyz, _190), dot(parameters.gToShadowZ.xyz, _190)), vec3(dot(parameters.gToShadowX.xyz, _202), dot(parameters.gToShadowY.xyz, _202), dot(parameters.gToShadowZ.xyz, _202)));
    float _208 = _207.z;
    bool _232 = _90 > parameters.gCascadeFar.x;
    bvec3 _233 = bvec3(_232);
    vec3 _234 = vec3(_233.x ? parameters.gCascadeScale1.xyz.x : vec3(1.0).x, _233.y ? parameters.gCascadeScale1.xyz.y : vec3(1.0).y, _233.z ? parameters.gCascadeScale1.xyz.z : vec3(1.0).z);
    vec3 _235 = vec3(_233.x ? parameters.gCascadeOffset1.xyz.x : vec3(0.0).x, _233.y ? parameters.gCascadeOffset1.xyz.y : vec3(0.0).y, _233.z ? parameters.gCascadeOffset1.xyz.z : vec3(0.0).z);
    bool _245 = _90 > parameters.gCascadeFar.y;
    bvec3 _246 = bvec3(_245);
    vec3 _247 = vec3(_246.x ? parameters.gCascadeScale2.xyz.x : _234.x, _246.y ? parameters.gCascadeScale2.xyz.y : _234.y, _246.z ? parameters.gCascadeScale2.xyz.z : _234.z);
    vec3 _251 = (vec3(dot(parameters.gToShadowX.xyz, _130), dot(parameters.gToShadowY.xyz, _130), dot(parameters.gToShadowZ.xyz, _130)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w)) * _247 + vec3(_246.x ? parameters.gCascadeOffset2.xyz.x : _235.x, _246.y ? parameters.gCascadeOffset2.xyz.y : _235.y, _246.z ? parameters.gCascadeOffset2.xyz.z : _235.z);
    float _252 = _247.z;
    vec2 _253 = _247.xy;
    vec2 _276 = floor(gl_FragCoord.xy);
    vec2 _278 = floor(_276 * 0.5);
    vec2 _280 = _276 - (_278 * 2.0);
    vec2 _284 = _278 - (floor(_278 * 0.5) * 2.0);
    float _285 = _280.x;
    float _286 = _280.y;
    float _288 = abs(_285 - _286);
    float _289 = _284.y;
    float _294 = _284.x;
    vec2 _306 = vec2((2.0 * abs(_294 - _289) + (8.0 * _288 + (4.0 * _286))) + _289, (2.0 * abs(abs(_289 - _286) - _294) + (4.0 * _285 + ((-8.0) * _288 + 8.0))) + _294) * vec2(0.0625);
    float _311 = floor(parameters.gSubsetCount);
    float _314 = (_311 > 1.0) ? min(_311, 16.0) : 1.0;
    float _318 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _324 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * ((-_314) * floor((_318 + 0.5) / _314) + _318);
    float _328 = 6.283185482025146484375 * (_324.x + _306.x);
    float _329 = cos(_328);
    float _330 = sin(_328);
    vec2 _334 = fract(vec2(0.5));
    float _336 = 6.283185482025146484375 * _334.x;
    float _337 = cos(_336);
    float _338 = sin(_336);
    vec2 _345 = _251.xy;
    vec2 _354 = clamp(floor((max(parameters.gDisc.xy * _253, vec2(parameters.gDisc.z)) * sqrt(fract(_334.y + (_324.y + _306.y)))) * vec2(_337 * _329 + (-(_338 * _330)), _337 * _330 + (_338 * _329)) + _345) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _384 = (_90 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_345 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_90 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2((float(_232) + float(_245)) * parameters.gCascadeSize.x + _354.x, _354.y) * parameters.gCascadeSize.zw, 0.0).x < ((-(parameters.gShadowBias.y * _90 + parameters.gShadowBias.x)) * _252 + min(_251.z + dot(clamp((-_207.xy) / vec2((abs(_208) > 9.9999996826552253889678874634872e-21) ? _208 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_252) / _253), _354 - _345), 1.0)))) : 1.0) : 1.0;
    gOutShadow = vec4(_384, _90, 0.0, 0.0);
}

