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
    vec3 gBias;
    float gSubsetCount;
} parameters;

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _76 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _80 = textureLod(gInCoarseDepth, _76, 0.0);
    float _81 = _80.x;
    float _83 = (_81 > 0.0) ? _81 : 65504.0;
    float _85 = (_83 < 65504.0) ? _83 : 65504.0;
    vec2 _89 = vec2(parameters.gOutputSize.z, 0.0);
    vec2 _91 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_89);
    vec4 _92 = textureLod(gInCoarseDepth, _91, 0.0);
    float _93 = _92.x;
    float _95 = (_93 > 0.0) ? _93 : 65504.0;
    float _97 = (_95 < 65504.0) ? _95 : 65504.0;
    vec2 _101 = vec2(0.0, parameters.gOutputSize.w);
    vec2 _103 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_101);
    vec4 _104 = textureLod(gInCoarseDepth, _103, 0.0);
    float _105 = _104.x;
    float _107 = (_105 > 0.0) ? _105 : 65504.0;
    float _109 = (_107 < 65504.0) ? _107 : 65504.0;
    vec2 _111 = gl_FragCoord.xy * parameters.gOutputSize.zw + _89;
    vec4 _112 = textureLod(gInCoarseDepth, _111, 0.0);
    float _113 = _112.x;
    float _115 = (_113 > 0.0) ? _113 : 65504.0;
    float _117 = (_115 < 65504.0) ? _115 : 65504.0;
    vec2 _119 = gl_FragCoord.xy * parameters.gOutputSize.zw + _101;
    vec4 _120 = textureLod(gInCoarseDepth, _119, 0.0);
    float _121 = _120.x;
    float _123 = (_121 > 0.0) ? _121 : 65504.0;
    float _125 = (_123 < 65504.0) ? _123 : 65504.0;
    vec3 _129 = vec3(_76 * _85, _85);
    float _162 = _117 - _85;
    vec2 _167 = vec2(_85 - _97, _97);
    vec2 _168 = vec2(_162, _117);
    bvec2 _169 = bvec2((all(lessThanEqual(abs(_91 - vec2(0.5)), vec2(0.5))) ? abs(_97 - _85) : 131008.0) < (all(lessThanEqual(abs(_111 - vec2(0.5)), vec2(0.5))) ? abs(_162) : 65504.0));
    vec2 _170 = vec2(_169.x ? _167.x : _168.x, _169.y ? _167.y : _168.y);
    float _171 = _170.x;
    vec3 _178 = vec3((_76 * _171) + (_89 * _170.y), _171);
    float _194 = _125 - _85;
    vec2 _199 = vec2(_85 - _109, _109);
    vec2 _200 = vec2(_194, _125);
    bvec2 _201 = bvec2((all(lessThanEqual(abs(_103 - vec2(0.5)), vec2(0.5))) ? abs(_109 - _85) : 131008.0) < (all(lessThanEqual(abs(_119 - vec2(0.5)), vec2(0.5))) ? abs(_194) : 65504.0));
    vec2 _202 = vec2(_201.x ? _199.x : _200.x, _201.y ? _199.y : _200.y);
    float _203 = _202.x;
    vec3 _210 = vec3((_76 * _203) + (_101 * _202.y), _203);
    vec3 _215 = cross(vec3(dot(parameters.gToShadowX.xyz, _178), dot(parameters.gToShadowY.xyz, _178), dot(parameters.gToShadowZ.xyz, _178)), vec3(dot(parameters.gToShadowX.xyz, _210), dot(parameters.gToShadowY.xyz, _210), dot(parameters.gToShadowZ.xyz, _210)));
    float _216 = _215.z;
    bool _240 = _85 > parameters.gCascadeFar.x;
    bvec3 _241 = bvec3(_240);
    vec3 _242 = vec3(_241.x ? parameters.gCascadeScale1.xyz.x : vec3(1.0).x, _241.y ? parameters.gCascadeScale1.xyz.y : vec3(1.0).y, _241.z ? parameters.gCascadeScale1.xyz.z : vec3(1.0).z);
    vec3 _243 = vec3(_241.x ? parameters.gCascadeOffset1.xyz.x : vec3(0.0).x, _241.y ? parameters.gCascadeOffset1.xyz.y : vec3(0.0).y, _241.z ? parameters.gCascadeOffset1.xyz.z : vec3(0.0).z);
    bool _253 = _85 > parameters.gCascadeFar.y;
    bvec3 _254 = bvec3(_253);
    vec3 _255 = vec3(_254.x ? parameters.gCascadeScale2.xyz.x : _242.x, _254.y ? parameters.gCascadeScale2.xyz.y : _242.y, _254.z ? parameters.gCascadeScale2.xyz.z : _242.z);
    vec3 _259 = (vec3(dot(parameters.gToShadowX.xyz, _129), dot(parameters.gToShadowY.xyz, _129), dot(parameters.gToShadowZ.xyz, _129)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w)) * _255 + vec3(_254.x ? parameters.gCascadeOffset2.xyz.x : _243.x, _254.y ? parameters.gCascadeOffset2.xyz.y : _243.y, _254.z ? parameters.gCascadeOffset2.xyz.z : _243.z);
    float _260 = _255.z;
    vec2 _261 = _255.xy;
    vec2 _284 = floor(gl_FragCoord.xy);
    float _289 = floor(parameters.gSubsetCount);
    float _292 = (_289 > 1.0) ? min(_289, 16.0) : 1.0;
    float _296 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _302 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * ((-_292) * floor((_296 + 0.5) / _292) + _296);
    vec2 _305 = floor(_284 * 0.5);
    vec2 _307 = _284 - (_305 * 2.0);
    vec2 _311 = _305 - (floor(_284 * 0.25) * 2.0);
    float _313 = _307.y;
    float _316 = _311.y;
    vec2 _322 = (abs(vec2(_307.x - _313, _311.x - _316)) * 2.0) + vec2(_313, _316);
    float _327 = 6.283185482025146484375 * ((4.0 * _322.x + _322.y) * 0.0625 + _302.x);
    float _328 = cos(_327);
    float _329 = sin(_327);
    vec2 _334 = vec2(_284.y + 1.0, _284.x);
    vec2 _336 = floor(_334 * 0.5);
    vec2 _338 = _334 - (_336 * 2.0);
    vec2 _342 = _336 - (floor(_334 * 0.25) * 2.0);
    float _344 = _338.y;
    float _347 = _342.y;
    vec2 _353 = (abs(vec2(_338.x - _344, _342.x - _347)) * 2.0) + vec2(_344, _347);
    vec2 _358 = fract(vec2(0.5));
    float _360 = 6.283185482025146484375 * _358.x;
    float _361 = cos(_360);
    float _362 = sin(_360);
    vec2 _369 = _259.xy;
    vec2 _378 = clamp(floor((max(parameters.gDisc.xy * _261, vec2(parameters.gDisc.z)) * sqrt(fract(_358.y + ((4.0 * _353.x + _353.y) * 0.0625 + _302.y)))) * vec2(_361 * _328 + (-(_362 * _329)), _361 * _329 + (_362 * _328)) + _369) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _409 = (_85 < 65504.0) ? ((all(lessThanEqual(abs((_369 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_85 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2((float(_240) + float(_253)) * parameters.gCascadeSize.x + _378.x, _378.y) * parameters.gCascadeSize.zw, 0.0).x < ((-(parameters.gBias.y * _85 + parameters.gBias.x)) * _260 + min(_259.z + dot(clamp((-_215.xy) / vec2((abs(_216) > 9.9999996826552253889678874634872e-21) ? _216 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_260) / _261), _378 - _369), 1.0)))) : 1.0) : 1.0;
    gOutShadow = vec4(_409, _85, 0.0, 0.0);
}

