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
    vec3 gBias;
    float gSubsetCount;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _78 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _82 = parameters.gOutputSize.zw * 0.5;
    vec4 _85 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_82));
    vec4 _88 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _82));
    float _89 = _85.y;
    float _91 = (_89 > 0.0) ? _89 : 65504.0;
    float _93 = (_91 < 65504.0) ? _91 : 65504.0;
    float _94 = _85.x;
    float _96 = (_94 > 0.0) ? _94 : 65504.0;
    float _98 = (_96 < 65504.0) ? _96 : 65504.0;
    float _99 = _85.z;
    float _101 = (_99 > 0.0) ? _99 : 65504.0;
    float _103 = (_101 < 65504.0) ? _101 : 65504.0;
    float _104 = _88.z;
    float _106 = (_104 > 0.0) ? _104 : 65504.0;
    float _108 = (_106 < 65504.0) ? _106 : 65504.0;
    float _109 = _88.x;
    float _111 = (_109 > 0.0) ? _109 : 65504.0;
    float _113 = (_111 < 65504.0) ? _111 : 65504.0;
    vec3 _117 = vec3(_78 * _93, _93);
    vec3 _138 = vec3(dot(parameters.gToShadowX.xyz, _117), dot(parameters.gToShadowY.xyz, _117), dot(parameters.gToShadowZ.xyz, _117)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
    vec2 _141 = vec2(parameters.gOutputSize.z, 0.0);
    float _156 = _108 - _93;
    vec2 _164 = mix(vec2(_156, _108), vec2(_93 - _98, _98), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_141) - vec2(0.5)), vec2(0.5))) ? abs(_98 - _93) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _141) - vec2(0.5)), vec2(0.5))) ? abs(_156) : 65504.0)));
    float _165 = _164.x;
    vec3 _172 = vec3((_78 * _165) + (_141 * _164.y), _165);
    vec2 _179 = vec2(0.0, parameters.gOutputSize.w);
    float _194 = _113 - _93;
    vec2 _202 = mix(vec2(_194, _113), vec2(_93 - _103, _103), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_179) - vec2(0.5)), vec2(0.5))) ? abs(_103 - _93) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _179) - vec2(0.5)), vec2(0.5))) ? abs(_194) : 65504.0)));
    float _203 = _202.x;
    vec3 _210 = vec3((_78 * _203) + (_179 * _202.y), _203);
    vec3 _215 = cross(vec3(dot(parameters.gToShadowX.xyz, _172), dot(parameters.gToShadowY.xyz, _172), dot(parameters.gToShadowZ.xyz, _172)), vec3(dot(parameters.gToShadowX.xyz, _210), dot(parameters.gToShadowY.xyz, _210), dot(parameters.gToShadowZ.xyz, _210)));
    float _216 = _215.z;
    vec2 _229 = clamp((-_215.xy) / vec2((abs(_216) > 9.9999996826552253889678874634872e-21) ? _216 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z));
    vec2 _238 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _247 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _248 = floor(gl_FragCoord.xy);
    float _253 = floor(parameters.gSubsetCount);
    float _256 = (_253 > 1.0) ? min(_253, 16.0) : 1.0;
    float _260 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _266 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_256, floor((_260 + 0.5) / _256), _260);
    vec2 _269 = floor(_248 * 0.5);
    vec2 _271 = _248 - (_269 * 2.0);
    vec2 _275 = _269 - (floor(_248 * 0.25) * 2.0);
    float _277 = _271.y;
    float _280 = _275.y;
    vec2 _286 = (abs(vec2(_271.x - _277, _275.x - _280)) * 2.0) + vec2(_277, _280);
    float _291 = 6.283185482025146484375 * fma(fma(4.0, _286.x, _286.y), 0.0625, _266.x);
    float _292 = cos(_291);
    float _293 = sin(_291);
    vec2 _298 = vec2(_248.y + 1.0, _248.x);
    vec2 _300 = floor(_298 * 0.5);
    vec2 _302 = _298 - (_300 * 2.0);
    vec2 _306 = _300 - (floor(_298 * 0.25) * 2.0);
    float _308 = _302.y;
    float _311 = _306.y;
    vec2 _317 = (abs(vec2(_302.x - _308, _306.x - _311)) * 2.0) + vec2(_308, _311);
    float _321 = fma(fma(4.0, _317.x, _317.y), 0.0625, _266.y);
    vec2 _322 = fract(vec2(0.5));
    float _324 = 6.283185482025146484375 * _322.x;
    float _325 = cos(_324);
    float _326 = sin(_324);
    vec2 _333 = _138.xy;
    vec2 _342 = clamp(floor(fma(_238 * sqrt(fract(_322.y + _321)), vec2(fma(_325, _292, -(_326 * _293)), fma(_325, _293, _326 * _292)), _333)) + vec2(0.5), vec2(0.5), _247);
    float _350 = _138.z;
    float _355 = -fma(parameters.gBias.y, _93, parameters.gBias.x);
    vec2 _359 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _361 = 6.283185482025146484375 * _359.x;
    float _362 = cos(_361);
    float _363 = sin(_361);
    vec2 _378 = clamp(floor(fma(_238 * sqrt(fract(_359.y + _321)), vec2(fma(_362, _292, -(_363 * _293)), fma(_362, _293, _363 * _292)), _333)) + vec2(0.5), vec2(0.5), _247);
    vec2 _391 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _393 = 6.283185482025146484375 * _391.x;
    float _394 = cos(_393);
    float _395 = sin(_393);
    vec2 _410 = clamp(floor(fma(_238 * sqrt(fract(_391.y + _321)), vec2(fma(_394, _292, -(_395 * _293)), fma(_394, _293, _395 * _292)), _333)) + vec2(0.5), vec2(0.5), _247);
    vec2 _423 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _425 = 6.283185482025146484375 * _423.x;
    float _426 = cos(_425);
    float _427 = sin(_425);
    vec2 _442 = clamp(floor(fma(_238 * sqrt(fract(_423.y + _321)), vec2(fma(_426, _292, -(_427 * _293)), fma(_426, _293, _427 * _292)), _333)) + vec2(0.5), vec2(0.5), _247);
    float _466 = (_93 < 65504.0) ? ((all(lessThanEqual(abs((_333 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_93 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _342 * parameters.gCascadeSize.zw, 0.0).x < fma(_355, 1.0, min(_350 + dot(_229, _342 - _333), 1.0))) + float(textureLod(gInShadowMap, _378 * parameters.gCascadeSize.zw, 0.0).x < fma(_355, 1.0, min(_350 + dot(_229, _378 - _333), 1.0)))) + float(textureLod(gInShadowMap, _410 * parameters.gCascadeSize.zw, 0.0).x < fma(_355, 1.0, min(_350 + dot(_229, _410 - _333), 1.0)))) + float(textureLod(gInShadowMap, _442 * parameters.gCascadeSize.zw, 0.0).x < fma(_355, 1.0, min(_350 + dot(_229, _442 - _333), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
    gOutShadow = vec4(_466, _93, 0.0, 0.0);
}

