#version 450

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _63 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _67 = parameters.gOutputSize.zw * 0.5;
    vec4 _70 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_67));
    vec4 _73 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _67));
    float _74 = _70.y;
    float _77 = (_74 > 0.0) ? min(_74, 65504.0) : 65504.0;
    float _78 = _70.x;
    float _81 = (_78 > 0.0) ? min(_78, 65504.0) : 65504.0;
    float _82 = _70.z;
    float _85 = (_82 > 0.0) ? min(_82, 65504.0) : 65504.0;
    float _86 = _73.z;
    float _89 = (_86 > 0.0) ? min(_86, 65504.0) : 65504.0;
    float _90 = _73.x;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    bvec2 _94 = greaterThan(_63, parameters.gOutputSize.zw);
    bvec2 _96 = lessThan(_63, vec2(1.0) - parameters.gOutputSize.zw);
    float _102 = _89 - _77;
    vec2 _110 = mix(vec2(_102, _89), vec2(_77 - _81, _81), bvec2((_94.x ? abs(_81 - _77) : 131008.0) < (_96.x ? abs(_102) : 65504.0)));
    float _116 = _93 - _77;
    vec2 _124 = mix(vec2(_116, _93), vec2(_77 - _85, _85), bvec2((_94.y ? abs(_85 - _77) : 131008.0) < (_96.y ? abs(_116) : 65504.0)));
    vec2 _136 = vec2(_110.x, _124.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_110.y, _124.y));
    vec3 _144 = normalize(vec3(_136, (-1.0) - dot(fma(_63, parameters.gViewRay.xy, parameters.gViewRay.zw), _136)));
    vec2 _145 = floor(gl_FragCoord.xy);
    vec2 _147 = floor(_145 * 0.5);
    vec2 _149 = _145 - (_147 * 2.0);
    vec2 _153 = _147 - (floor(_147 * 0.5) * 2.0);
    float _154 = _149.x;
    float _155 = _149.y;
    float _157 = abs(_154 - _155);
    float _158 = _153.y;
    float _163 = _153.x;
    vec2 _175 = vec2(fma(2.0, abs(_163 - _158), fma(8.0, _157, 4.0 * _155)) + _158, fma(2.0, abs(abs(_158 - _155) - _163), fma(4.0, _154, fma(-8.0, _157, 8.0))) + _163) * vec2(0.0625);
    float _177 = 6.283185482025146484375 * _175.x;
    float _178 = cos(_177);
    float _179 = sin(_177);
    vec2 _187 = vec2(1.0) / parameters.gViewRay.xy;
    float _192 = _144.z;
    float _194 = (_192 >= 0.0) ? 1.0 : (-1.0);
    float _196 = (-1.0) / (_194 + _192);
    float _197 = _144.x;
    float _198 = _144.y;
    float _200 = (_197 * _198) * _196;
    vec3 _207 = vec3(fma((_194 * _197) * _197, _196, 1.0), _194 * _200, (-_194) * _197);
    vec3 _211 = vec3(_200, fma(_198 * _198, _196, _194), -_198);
    vec3 _217 = ((_207 * _178) + (_211 * _179)) * parameters.gRadius;
    float _219 = _217.z;
    vec3 _229 = ((_211 * _178) - (_207 * _179)) * parameters.gRadius;
    float _231 = _229.z;
    vec3 _238 = _144 * parameters.gRadius;
    float _240 = _238.z;
    vec3 _263 = vec3(_63 * _77, _77) + ((((vec3((_217.xy - (parameters.gViewRay.zw * _219)) * _187, _219) * parameters.gTaps[0].x) + (vec3((_229.xy - (parameters.gViewRay.zw * _231)) * _187, _231) * parameters.gTaps[0].y)) + (vec3((_238.xy - (parameters.gViewRay.zw * _240)) * _187, _240) * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _175.y)));
    float _266 = _263.z;
    vec2 _268 = _263.xy * (1.0 / _266);
    vec4 _275 = textureLod(gInCoarseDepth, _268, 0.0);
    float _276 = _275.x;
    float _280 = _266 - ((_276 > 0.0) ? min(_276, 65504.0) : 65504.0);
    vec2 _289 = mix(vec2(0.0), vec2(clamp(fma(_280, 1.0 / max(fma(parameters.gOcclusionBias.y, _77, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07), -1.0), 0.0, 1.0) * clamp(fma(-_280, 1.0 / parameters.gRadius, 2.0), 0.0, 1.0), 1.0), bvec2((_266 > 0.0) && all(lessThanEqual(floatBitsToUint(_268), uvec2(1065353216u)))));
    gOutOcclusion = vec4((_77 < 65504.0) ? (1.0 - (_289.x / max(_289.y, 1.0))) : 1.0, _77, 0.0, 0.0);
}

