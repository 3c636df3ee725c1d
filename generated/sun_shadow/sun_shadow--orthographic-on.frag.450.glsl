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
    vec2 _89 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _93 = parameters.gOutputSize.zw * 0.5;
    vec4 _96 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_93));
    vec4 _99 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _93));
    float _100 = _96.y;
    float _103 = (_100 > 0.0) ? min(_100, 65504.0) : 65504.0;
    float _104 = _96.x;
    float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
    float _108 = _96.z;
    float _111 = (_108 > 0.0) ? min(_108, 65504.0) : 65504.0;
    float _112 = _99.z;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    float _116 = _99.x;
    float _119 = (_116 > 0.0) ? min(_116, 65504.0) : 65504.0;
    vec3 _122 = vec3(_89, _103);
    bvec2 _144 = greaterThan(_89, parameters.gOutputSize.zw);
    bvec2 _146 = lessThan(_89, vec2(1.0) - parameters.gOutputSize.zw);
    float _152 = _115 - _103;
    float _166 = _119 - _103;
    vec3 _178 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_152, _115), vec2(_103 - _107, _107), bvec2((_144.x ? abs(_107 - _103) : 131008.0) < (_146.x ? abs(_152) : 65504.0))).x);
    vec3 _186 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_166, _119), vec2(_103 - _111, _111), bvec2((_144.y ? abs(_111 - _103) : 131008.0) < (_146.y ? abs(_166) : 65504.0))).x);
    vec3 _191 = cross(vec3(dot(parameters.gToShadowX.xyz, _178), dot(parameters.gToShadowY.xyz, _178), dot(parameters.gToShadowZ.xyz, _178)), vec3(dot(parameters.gToShadowX.xyz, _186), dot(parameters.gToShadowY.xyz, _186), dot(parameters.gToShadowZ.xyz, _186)));
    bool _216 = _103 > parameters.gCascadeFar.x;
    bvec3 _217 = bvec3(_216);
    bool _229 = _103 > parameters.gCascadeFar.y;
    bvec3 _230 = bvec3(_229);
    vec3 _231 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _217), parameters.gCascadeScale2.xyz, _230);
    float _234 = float(_216) + float(_229);
    vec3 _235 = fma(vec3(dot(parameters.gToShadowX.xyz, _122), dot(parameters.gToShadowY.xyz, _122), dot(parameters.gToShadowZ.xyz, _122)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _231, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _217), parameters.gCascadeOffset2.xyz, _230));
    float _236 = _231.z;
    vec2 _237 = _231.xy;
    vec2 _240 = clamp((-_191.xy) / vec2((abs(_191.z) > 9.9999996826552253889678874634872e-21) ? _191.z : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_236) / _237);
    vec2 _248 = max(parameters.gDisc.xy * _237, vec2(parameters.gDisc.z));
    vec2 _257 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _260 = floor(gl_FragCoord.xy);
    vec2 _262 = floor(_260 * 0.5);
    vec2 _264 = _260 - (_262 * 2.0);
    vec2 _268 = _262 - (floor(_262 * 0.5) * 2.0);
    float _269 = _264.x;
    float _270 = _264.y;
    float _272 = abs(_269 - _270);
    float _273 = _268.y;
    float _278 = _268.x;
    vec2 _290 = vec2(fma(2.0, abs(_278 - _273), fma(8.0, _272, 4.0 * _270)) + _273, fma(2.0, abs(abs(_273 - _270) - _278), fma(4.0, _269, fma(-8.0, _272, 8.0))) + _278) * vec2(0.0625);
    float _295 = floor(parameters.gSubsetCount);
    float _298 = (_295 > 1.0) ? min(_295, 16.0) : 1.0;
    float _302 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _308 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_298, floor((_302 + 0.5) / _298), _302);
    float _312 = 6.283185482025146484375 * (_308.x + _290.x);
    float _313 = cos(_312);
    float _314 = sin(_312);
    float _317 = _308.y + _290.y;
    vec2 _318 = fract(vec2(0.5));
    float _320 = 6.283185482025146484375 * _318.x;
    float _321 = cos(_320);
    float _322 = sin(_320);
    vec2 _329 = _235.xy;
    vec2 _338 = clamp(floor(fma(_248 * sqrt(fract(_318.y + _317)), vec2(fma(_321, _313, -(_322 * _314)), fma(_321, _314, _322 * _313)), _329)) + vec2(0.5), vec2(0.5), _257);
    float _350 = _235.z;
    float _355 = -fma(parameters.gShadowBias.y, _103, parameters.gShadowBias.x);
    vec2 _359 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _361 = 6.283185482025146484375 * _359.x;
    float _362 = cos(_361);
    float _363 = sin(_361);
    vec2 _378 = clamp(floor(fma(_248 * sqrt(fract(_359.y + _317)), vec2(fma(_362, _313, -(_363 * _314)), fma(_362, _314, _363 * _313)), _329)) + vec2(0.5), vec2(0.5), _257);
    vec2 _395 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _397 = 6.283185482025146484375 * _395.x;
    float _398 = cos(_397);
    float _399 = sin(_397);
    vec2 _414 = clamp(floor(fma(_248 * sqrt(fract(_395.y + _317)), vec2(fma(_398, _313, -(_399 * _314)), fma(_398, _314, _399 * _313)), _329)) + vec2(0.5), vec2(0.5), _257);
    vec2 _431 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _433 = 6.283185482025146484375 * _431.x;
    float _434 = cos(_433);
    float _435 = sin(_433);
    vec2 _450 = clamp(floor(fma(_248 * sqrt(fract(_431.y + _317)), vec2(fma(_434, _313, -(_435 * _314)), fma(_434, _314, _435 * _313)), _329)) + vec2(0.5), vec2(0.5), _257);
    float _474 = -(((float(textureLod(gInShadowMap, vec2(fma(_234, parameters.gCascadeSize.x, _338.x), _338.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_355, _236, min(_350 + dot(_240, _338 - _329), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_234, parameters.gCascadeSize.x, _378.x), _378.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_355, _236, min(_350 + dot(_240, _378 - _329), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_234, parameters.gCascadeSize.x, _414.x), _414.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_355, _236, min(_350 + dot(_240, _414 - _329), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_234, parameters.gCascadeSize.x, _450.x), _450.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_355, _236, min(_350 + dot(_240, _450 - _329), 1.0))));
    gOutShadow = vec4((_103 < 65504.0) ? ((all(lessThanEqual(abs((_329 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_103 <= parameters.gCascadeFar.z)) ? fma(_474, 0.25, 1.0) : 1.0) : 1.0, _103, 0.0, 0.0);
}

