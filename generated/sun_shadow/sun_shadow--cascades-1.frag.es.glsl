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
    vec3 _151 = vec3(dot(parameters.gToShadowX.xyz, _130), dot(parameters.gToShadowY.xyz, _130), dot(parameters.gToShadowZ.xyz, _130)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
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
    vec2 _221 = clamp((-_207.xy) / vec2((abs(_208) > 9.9999996826552253889678874634872e-21) ? _208 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
    vec2 _230 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _239 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _240 = floor(gl_FragCoord.xy);
    vec2 _242 = floor(_240 * 0.5);
    vec2 _244 = _240 - (_242 * 2.0);
    vec2 _248 = _242 - (floor(_242 * 0.5) * 2.0);
    float _249 = _244.x;
    float _250 = _244.y;
    float _252 = abs(_249 - _250);
    float _253 = _248.y;
    float _258 = _248.x;
    vec2 _270 = vec2((2.0 * abs(_258 - _253) + (8.0 * _252 + (4.0 * _250))) + _253, (2.0 * abs(abs(_253 - _250) - _258) + (4.0 * _249 + ((-8.0) * _252 + 8.0))) + _258) * vec2(0.0625);
    float _275 = floor(parameters.gSubsetCount);
    float _278 = (_275 > 1.0) ? min(_275, 16.0) : 1.0;
    float _282 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _288 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * ((-_278) * floor((_282 + 0.5) / _278) + _282);
    float _292 = 6.283185482025146484375 * (_288.x + _270.x);
    float _293 = cos(_292);
    float _294 = sin(_292);
    float _297 = _288.y + _270.y;
    vec2 _298 = fract(vec2(0.5));
    float _300 = 6.283185482025146484375 * _298.x;
    float _301 = cos(_300);
    float _302 = sin(_300);
    vec2 _309 = _151.xy;
    vec2 _318 = clamp(floor((_230 * sqrt(fract(_298.y + _297))) * vec2(_301 * _293 + (-(_302 * _294)), _301 * _294 + (_302 * _293)) + _309) + vec2(0.5), vec2(0.5), _239);
    float _326 = _151.z;
    float _331 = -(parameters.gShadowBias.y * _90 + parameters.gShadowBias.x);
    vec2 _335 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _337 = 6.283185482025146484375 * _335.x;
    float _338 = cos(_337);
    float _339 = sin(_337);
    vec2 _354 = clamp(floor((_230 * sqrt(fract(_335.y + _297))) * vec2(_338 * _293 + (-(_339 * _294)), _338 * _294 + (_339 * _293)) + _309) + vec2(0.5), vec2(0.5), _239);
    vec2 _367 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _369 = 6.283185482025146484375 * _367.x;
    float _370 = cos(_369);
    float _371 = sin(_369);
    vec2 _386 = clamp(floor((_230 * sqrt(fract(_367.y + _297))) * vec2(_370 * _293 + (-(_371 * _294)), _370 * _294 + (_371 * _293)) + _309) + vec2(0.5), vec2(0.5), _239);
    vec2 _399 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _401 = 6.283185482025146484375 * _399.x;
    float _402 = cos(_401);
    float _403 = sin(_401);
    vec2 _418 = clamp(floor((_230 * sqrt(fract(_399.y + _297))) * vec2(_402 * _293 + (-(_403 * _294)), _402 * _294 + (_403 * _293)) + _309) + vec2(0.5), vec2(0.5), _239);
    float _442 = (_90 < 65504.0) ? ((all(lessThanEqual(abs((_309 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_90 <= parameters.gCascadeFar.x)) ? ((-(((float(textureLod(gInShadowMap, _318 * parameters.gCascadeSize.zw, 0.0).x < (_331 * 1.0 + min(_326 + dot(_221, _318 - _309), 1.0))) + float(textureLod(gInShadowMap, _354 * parameters.gCascadeSize.zw, 0.0).x < (_331 * 1.0 + min(_326 + dot(_221, _354 - _309), 1.0)))) + float(textureLod(gInShadowMap, _386 * parameters.gCascadeSize.zw, 0.0).x < (_331 * 1.0 + min(_326 + dot(_221, _386 - _309), 1.0)))) + float(textureLod(gInShadowMap, _418 * parameters.gCascadeSize.zw, 0.0).x < (_331 * 1.0 + min(_326 + dot(_221, _418 - _309), 1.0))))) * 0.25 + 1.0) : 1.0) : 1.0;
    gOutShadow = vec4(_442, _90, 0.0, 0.0);
}

