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
    vec2 _66 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _70 = textureLod(gInCoarseDepth, _66, 0.0);
    float _71 = _70.x;
    float _74 = (_71 > 0.0) ? min(_71, 65504.0) : 65504.0;
    vec2 _77 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _81 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_77), 0.0);
    float _82 = _81.x;
    float _85 = (_82 > 0.0) ? min(_82, 65504.0) : 65504.0;
    vec2 _88 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _92 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_88), 0.0);
    float _93 = _92.x;
    float _96 = (_93 > 0.0) ? min(_93, 65504.0) : 65504.0;
    vec4 _99 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _77, 0.0);
    float _100 = _99.x;
    float _103 = (_100 > 0.0) ? min(_100, 65504.0) : 65504.0;
    vec4 _106 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _88, 0.0);
    float _107 = _106.x;
    float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
    bvec2 _111 = greaterThan(_66, parameters.gOutputSize.zw);
    bvec2 _113 = lessThan(_66, vec2(1.0) - parameters.gOutputSize.zw);
    float _119 = _103 - _74;
    vec2 _124 = vec2(_74 - _85, _85);
    vec2 _125 = vec2(_119, _103);
    bvec2 _126 = bvec2((_111.x ? abs(_85 - _74) : 131008.0) < (_113.x ? abs(_119) : 65504.0));
    float _133 = _110 - _74;
    vec2 _138 = vec2(_74 - _96, _96);
    vec2 _139 = vec2(_133, _110);
    bvec2 _140 = bvec2((_111.y ? abs(_96 - _74) : 131008.0) < (_113.y ? abs(_133) : 65504.0));
    vec3 _153 = normalize(vec3(vec2(vec2(_126.x ? _124.x : _125.x, _126.y ? _124.y : _125.y).x, vec2(_140.x ? _138.x : _139.x, _140.y ? _138.y : _139.y).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
    vec2 _154 = floor(gl_FragCoord.xy);
    vec2 _156 = floor(_154 * 0.5);
    vec2 _158 = _154 - (_156 * 2.0);
    vec2 _162 = _156 - (floor(_156 * 0.5) * 2.0);
    float _163 = _158.x;
    float _164 = _158.y;
    float _166 = abs(_163 - _164);
    float _167 = _162.y;
    float _172 = _162.x;
    vec2 _184 = vec2((2.0 * abs(_172 - _167) + (8.0 * _166 + (4.0 * _164))) + _167, (2.0 * abs(abs(_167 - _164) - _172) + (4.0 * _163 + ((-8.0) * _166 + 8.0))) + _172) * vec2(0.0625);
    float _186 = 6.283185482025146484375 * _184.x;
    float _187 = cos(_186);
    float _188 = sin(_186);
    float _195 = 1.0 / max(parameters.gOcclusionBias.y * _74 + parameters.gOcclusionBias.x, 9.9999999747524270787835121154785e-07);
    vec2 _196 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _199 = vec3(_66, _74);
    float _200 = _153.z;
    float _202 = (_200 >= 0.0) ? 1.0 : (-1.0);
    float _204 = (-1.0) / (_202 + _200);
    float _205 = _153.x;
    float _206 = _153.y;
    float _208 = (_205 * _206) * _204;
    vec3 _215 = vec3(((_202 * _205) * _205) * _204 + 1.0, _202 * _208, (-_202) * _205);
    vec3 _219 = vec3(_208, (_206 * _206) * _204 + _202, -_206);
    vec3 _225 = ((_215 * _187) + (_219 * _188)) * parameters.gRadius;
    vec3 _231 = vec3(_225.xy * _196, _225.z);
    vec3 _235 = ((_219 * _187) - (_215 * _188)) * parameters.gRadius;
    vec3 _241 = vec3(_235.xy * _196, _235.z);
    vec3 _242 = _153 * parameters.gRadius;
    vec3 _248 = vec3(_242.xy * _196, _242.z);
    float _260 = _184.y;
    vec3 _265 = _199 + ((((_231 * parameters.gTaps[0].x) + (_241 * parameters.gTaps[0].y)) + (_248 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _260)));
    float _266 = 1.0 / parameters.gRadius;
    vec2 _267 = _265.xy;
    float _268 = _265.z;
    vec4 _275 = textureLod(gInCoarseDepth, _267, 0.0);
    float _276 = _275.x;
    float _280 = _268 - ((_276 > 0.0) ? min(_276, 65504.0) : 65504.0);
    vec2 _287 = vec2(clamp(_280 * _195 + (-1.0), 0.0, 1.0) * clamp((-_280) * _266 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _288 = bvec2((_268 > 0.0) && all(lessThanEqual(floatBitsToUint(_267), uvec2(1065353216u))));
    vec3 _305 = _199 + ((((_231 * parameters.gTaps[1].x) + (_241 * parameters.gTaps[1].y)) + (_248 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _260)));
    vec2 _306 = _305.xy;
    float _307 = _305.z;
    vec4 _314 = textureLod(gInCoarseDepth, _306, 0.0);
    float _315 = _314.x;
    float _319 = _307 - ((_315 > 0.0) ? min(_315, 65504.0) : 65504.0);
    vec2 _326 = vec2(clamp(_319 * _195 + (-1.0), 0.0, 1.0) * clamp((-_319) * _266 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _327 = bvec2((_307 > 0.0) && all(lessThanEqual(floatBitsToUint(_306), uvec2(1065353216u))));
    vec3 _345 = _199 + ((((_231 * parameters.gTaps[2].x) + (_241 * parameters.gTaps[2].y)) + (_248 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _260)));
    vec2 _346 = _345.xy;
    float _347 = _345.z;
    vec4 _354 = textureLod(gInCoarseDepth, _346, 0.0);
    float _355 = _354.x;
    float _359 = _347 - ((_355 > 0.0) ? min(_355, 65504.0) : 65504.0);
    vec2 _366 = vec2(clamp(_359 * _195 + (-1.0), 0.0, 1.0) * clamp((-_359) * _266 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _367 = bvec2((_347 > 0.0) && all(lessThanEqual(floatBitsToUint(_346), uvec2(1065353216u))));
    vec3 _385 = _199 + ((((_231 * parameters.gTaps[3].x) + (_241 * parameters.gTaps[3].y)) + (_248 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _260)));
    vec2 _386 = _385.xy;
    float _387 = _385.z;
    vec4 _394 = textureLod(gInCoarseDepth, _386, 0.0);
    float _395 = _394.x;
    float _399 = _387 - ((_395 > 0.0) ? min(_395, 65504.0) : 65504.0);
    vec2 _406 = vec2(clamp(_399 * _195 + (-1.0), 0.0, 1.0) * clamp((-_399) * _266 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _407 = bvec2((_387 > 0.0) && all(lessThanEqual(floatBitsToUint(_386), uvec2(1065353216u))));
    vec2 _409 = ((vec2(_288.x ? _287.x : vec2(0.0).x, _288.y ? _287.y : vec2(0.0).y) + vec2(_327.x ? _326.x : vec2(0.0).x, _327.y ? _326.y : vec2(0.0).y)) + vec2(_367.x ? _366.x : vec2(0.0).x, _367.y ? _366.y : vec2(0.0).y)) + vec2(_407.x ? _406.x : vec2(0.0).x, _407.y ? _406.y : vec2(0.0).y);
    gOutOcclusion = vec4((_74 < 65504.0) ? (1.0 - (_409.x / max(_409.y, 1.0))) : 1.0, _74, 0.0, 0.0);
}

