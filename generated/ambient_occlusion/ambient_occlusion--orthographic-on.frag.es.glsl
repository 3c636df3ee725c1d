#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

uniform highp sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _64 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _68 = textureLod(gInCoarseDepth, _64, 0.0);
    float _69 = _68.x;
    float _72 = (_69 > 0.0) ? min(_69, 65504.0) : 65504.0;
    vec2 _75 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _79 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_75), 0.0);
    float _80 = _79.x;
    float _83 = (_80 > 0.0) ? min(_80, 65504.0) : 65504.0;
    vec2 _86 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _90 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_86), 0.0);
    float _91 = _90.x;
    float _94 = (_91 > 0.0) ? min(_91, 65504.0) : 65504.0;
    vec4 _97 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _75, 0.0);
    float _98 = _97.x;
    float _101 = (_98 > 0.0) ? min(_98, 65504.0) : 65504.0;
    vec4 _104 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _86, 0.0);
    float _105 = _104.x;
    float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
    bvec2 _109 = greaterThan(_64, parameters.gOutputSize.zw);
    bvec2 _111 = lessThan(_64, vec2(1.0) - parameters.gOutputSize.zw);
    float _117 = _101 - _72;
    vec2 _122 = vec2(_72 - _83, _83);
    vec2 _123 = vec2(_117, _101);
    bvec2 _124 = bvec2((_109.x ? abs(_83 - _72) : 131008.0) < (_111.x ? abs(_117) : 65504.0));
    float _131 = _108 - _72;
    vec2 _136 = vec2(_72 - _94, _94);
    vec2 _137 = vec2(_131, _108);
    bvec2 _138 = bvec2((_109.y ? abs(_94 - _72) : 131008.0) < (_111.y ? abs(_131) : 65504.0));
    vec3 _151 = normalize(vec3(vec2(vec2(_124.x ? _122.x : _123.x, _124.y ? _122.y : _123.y).x, vec2(_138.x ? _136.x : _137.x, _138.y ? _136.y : _137.y).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
    vec2 _152 = floor(gl_FragCoord.xy);
    vec2 _154 = floor(_152 * 0.5);
    vec2 _156 = _152 - (_154 * 2.0);
    vec2 _160 = _154 - (floor(_154 * 0.5) * 2.0);
    float _161 = _156.x;
    float _162 = _156.y;
    float _164 = abs(_161 - _162);
    float _165 = _160.y;
    float _170 = _160.x;
    vec2 _182 = vec2((2.0 * abs(_170 - _165) + (8.0 * _164 + (4.0 * _162))) + _165, (2.0 * abs(abs(_165 - _162) - _170) + (4.0 * _161 + ((-8.0) * _164 + 8.0))) + _170) * vec2(0.0625);
    float _184 = 6.283185482025146484375 * _182.x;
    float _185 = cos(_184);
    float _186 = sin(_184);
    float _193 = 1.0 / max(parameters.gOcclusionBias.y * _72 + parameters.gOcclusionBias.x, 9.9999999747524270787835121154785e-07);
    vec2 _194 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _197 = vec3(_64, _72);
    float _198 = _151.z;
    float _200 = (_198 >= 0.0) ? 1.0 : (-1.0);
    float _202 = (-1.0) / (_200 + _198);
    float _203 = _151.x;
    float _204 = _151.y;
    float _206 = (_203 * _204) * _202;
    vec3 _213 = vec3(((_200 * _203) * _203) * _202 + 1.0, _200 * _206, (-_200) * _203);
    vec3 _217 = vec3(_206, (_204 * _204) * _202 + _200, -_204);
    vec3 _223 = ((_213 * _185) + (_217 * _186)) * parameters.gRadius;
    vec3 _229 = vec3(_223.xy * _194, _223.z);
    vec3 _233 = ((_217 * _185) - (_213 * _186)) * parameters.gRadius;
    vec3 _239 = vec3(_233.xy * _194, _233.z);
    vec3 _240 = _151 * parameters.gRadius;
    vec3 _246 = vec3(_240.xy * _194, _240.z);
    float _258 = _182.y;
    vec3 _263 = _197 + ((((_229 * parameters.gTaps[0].x) + (_239 * parameters.gTaps[0].y)) + (_246 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _258)));
    float _264 = 1.0 / parameters.gRadius;
    vec2 _265 = _263.xy;
    float _266 = _263.z;
    vec4 _274 = textureLod(gInCoarseDepth, _265, 0.0);
    float _275 = _274.x;
    float _279 = _266 - ((_275 > 0.0) ? min(_275, 65504.0) : 65504.0);
    vec2 _286 = vec2(clamp(_279 * _193 + (-1.0), 0.0, 1.0) * clamp((-_279) * _264 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _287 = bvec2((_266 > 0.0) && all(lessThanEqual(abs(_265 - vec2(0.5)), vec2(0.5))));
    vec3 _304 = _197 + ((((_229 * parameters.gTaps[1].x) + (_239 * parameters.gTaps[1].y)) + (_246 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _258)));
    vec2 _305 = _304.xy;
    float _306 = _304.z;
    vec4 _314 = textureLod(gInCoarseDepth, _305, 0.0);
    float _315 = _314.x;
    float _319 = _306 - ((_315 > 0.0) ? min(_315, 65504.0) : 65504.0);
    vec2 _326 = vec2(clamp(_319 * _193 + (-1.0), 0.0, 1.0) * clamp((-_319) * _264 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _327 = bvec2((_306 > 0.0) && all(lessThanEqual(abs(_305 - vec2(0.5)), vec2(0.5))));
    vec3 _345 = _197 + ((((_229 * parameters.gTaps[2].x) + (_239 * parameters.gTaps[2].y)) + (_246 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _258)));
    vec2 _346 = _345.xy;
    float _347 = _345.z;
    vec4 _355 = textureLod(gInCoarseDepth, _346, 0.0);
    float _356 = _355.x;
    float _360 = _347 - ((_356 > 0.0) ? min(_356, 65504.0) : 65504.0);
    vec2 _367 = vec2(clamp(_360 * _193 + (-1.0), 0.0, 1.0) * clamp((-_360) * _264 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _368 = bvec2((_347 > 0.0) && all(lessThanEqual(abs(_346 - vec2(0.5)), vec2(0.5))));
    vec3 _386 = _197 + ((((_229 * parameters.gTaps[3].x) + (_239 * parameters.gTaps[3].y)) + (_246 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _258)));
    vec2 _387 = _386.xy;
    float _388 = _386.z;
    vec4 _396 = textureLod(gInCoarseDepth, _387, 0.0);
    float _397 = _396.x;
    float _401 = _388 - ((_397 > 0.0) ? min(_397, 65504.0) : 65504.0);
    vec2 _408 = vec2(clamp(_401 * _193 + (-1.0), 0.0, 1.0) * clamp((-_401) * _264 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _409 = bvec2((_388 > 0.0) && all(lessThanEqual(abs(_387 - vec2(0.5)), vec2(0.5))));
    vec2 _411 = ((vec2(_287.x ? _286.x : vec2(0.0).x, _287.y ? _286.y : vec2(0.0).y) + vec2(_327.x ? _326.x : vec2(0.0).x, _327.y ? _326.y : vec2(0.0).y)) + vec2(_368.x ? _367.x : vec2(0.0).x, _368.y ? _367.y : vec2(0.0).y)) + vec2(_409.x ? _408.x : vec2(0.0).x, _409.y ? _408.y : vec2(0.0).y);
    gOutOcclusion = vec4((_72 < 65504.0) ? (1.0 - (_411.x / max(_411.y, 1.0))) : 1.0, _72, 0.0, 0.0);
}

