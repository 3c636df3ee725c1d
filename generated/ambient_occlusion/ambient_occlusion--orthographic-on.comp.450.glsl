#version 450
layout(local_size_x = 32, local_size_y = 32, local_size_z = 1) in;

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

layout(binding = 16) uniform writeonly image2D gOutOcclusion;
layout(binding = 1) uniform sampler2D gInCoarseDepth;

void main()
{
    vec2 _63 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _67 = _63 * parameters.gOutputSize.zw;
    vec2 _71 = parameters.gOutputSize.zw * 0.5;
    vec4 _74 = textureGather(gInCoarseDepth, fma(_63, parameters.gOutputSize.zw, -_71));
    vec4 _77 = textureGather(gInCoarseDepth, fma(_63, parameters.gOutputSize.zw, _71));
    float _78 = _74.y;
    float _81 = (_78 > 0.0) ? min(_78, 65504.0) : 65504.0;
    float _82 = _74.x;
    float _85 = (_82 > 0.0) ? min(_82, 65504.0) : 65504.0;
    float _86 = _74.z;
    float _89 = (_86 > 0.0) ? min(_86, 65504.0) : 65504.0;
    float _90 = _77.z;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    float _94 = _77.x;
    float _97 = (_94 > 0.0) ? min(_94, 65504.0) : 65504.0;
    bvec2 _98 = greaterThan(_67, parameters.gOutputSize.zw);
    bvec2 _100 = lessThan(_67, vec2(1.0) - parameters.gOutputSize.zw);
    float _106 = _93 - _81;
    float _120 = _97 - _81;
    vec3 _140 = normalize(vec3(vec2(mix(vec2(_106, _93), vec2(_81 - _85, _85), bvec2((_98.x ? abs(_85 - _81) : 131008.0) < (_100.x ? abs(_106) : 65504.0))).x, mix(vec2(_120, _97), vec2(_81 - _89, _89), bvec2((_98.y ? abs(_89 - _81) : 131008.0) < (_100.y ? abs(_120) : 65504.0))).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
    vec2 _141 = floor(_63);
    vec2 _143 = floor(_141 * 0.5);
    vec2 _145 = _141 - (_143 * 2.0);
    vec2 _149 = _143 - (floor(_143 * 0.5) * 2.0);
    float _150 = _145.x;
    float _151 = _145.y;
    float _153 = abs(_150 - _151);
    float _154 = _149.y;
    float _159 = _149.x;
    vec2 _171 = vec2(fma(2.0, abs(_159 - _154), fma(8.0, _153, 4.0 * _151)) + _154, fma(2.0, abs(abs(_154 - _151) - _159), fma(4.0, _150, fma(-8.0, _153, 8.0))) + _159) * vec2(0.0625);
    float _173 = 6.283185482025146484375 * _171.x;
    float _174 = cos(_173);
    float _175 = sin(_173);
    float _182 = 1.0 / max(fma(parameters.gOcclusionBias.y, _81, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _183 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _186 = vec3(_67, _81);
    float _187 = _140.z;
    float _189 = (_187 >= 0.0) ? 1.0 : (-1.0);
    float _191 = (-1.0) / (_189 + _187);
    float _192 = _140.x;
    float _193 = _140.y;
    float _195 = (_192 * _193) * _191;
    vec3 _202 = vec3(fma((_189 * _192) * _192, _191, 1.0), _189 * _195, (-_189) * _192);
    vec3 _206 = vec3(_195, fma(_193 * _193, _191, _189), -_193);
    vec3 _212 = ((_202 * _174) + (_206 * _175)) * parameters.gRadius;
    vec3 _218 = vec3(_212.xy * _183, _212.z);
    vec3 _222 = ((_206 * _174) - (_202 * _175)) * parameters.gRadius;
    vec3 _228 = vec3(_222.xy * _183, _222.z);
    vec3 _229 = _140 * parameters.gRadius;
    vec3 _235 = vec3(_229.xy * _183, _229.z);
    float _247 = _171.y;
    vec3 _252 = _186 + ((((_218 * parameters.gTaps[0].x) + (_228 * parameters.gTaps[0].y)) + (_235 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _247)));
    float _253 = 1.0 / parameters.gRadius;
    vec2 _254 = _252.xy;
    float _255 = _252.z;
    vec4 _263 = textureLod(gInCoarseDepth, _254, 0.0);
    float _264 = _263.x;
    float _268 = _255 - ((_264 > 0.0) ? min(_264, 65504.0) : 65504.0);
    vec3 _293 = _186 + ((((_218 * parameters.gTaps[1].x) + (_228 * parameters.gTaps[1].y)) + (_235 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _247)));
    vec2 _294 = _293.xy;
    float _295 = _293.z;
    vec4 _303 = textureLod(gInCoarseDepth, _294, 0.0);
    float _304 = _303.x;
    float _308 = _295 - ((_304 > 0.0) ? min(_304, 65504.0) : 65504.0);
    vec3 _334 = _186 + ((((_218 * parameters.gTaps[2].x) + (_228 * parameters.gTaps[2].y)) + (_235 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _247)));
    vec2 _335 = _334.xy;
    float _336 = _334.z;
    vec4 _344 = textureLod(gInCoarseDepth, _335, 0.0);
    float _345 = _344.x;
    float _349 = _336 - ((_345 > 0.0) ? min(_345, 65504.0) : 65504.0);
    vec3 _375 = _186 + ((((_218 * parameters.gTaps[3].x) + (_228 * parameters.gTaps[3].y)) + (_235 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _247)));
    vec2 _376 = _375.xy;
    float _377 = _375.z;
    vec4 _385 = textureLod(gInCoarseDepth, _376, 0.0);
    float _386 = _385.x;
    float _390 = _377 - ((_386 > 0.0) ? min(_386, 65504.0) : 65504.0);
    vec2 _400 = ((mix(vec2(0.0), vec2(clamp(fma(_268, _182, -1.0), 0.0, 1.0) * clamp(fma(-_268, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_255 > 0.0) && all(lessThanEqual(abs(_254 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_308, _182, -1.0), 0.0, 1.0) * clamp(fma(-_308, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_295 > 0.0) && all(lessThanEqual(abs(_294 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_349, _182, -1.0), 0.0, 1.0) * clamp(fma(-_349, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_336 > 0.0) && all(lessThanEqual(abs(_335 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_390, _182, -1.0), 0.0, 1.0) * clamp(fma(-_390, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_377 > 0.0) && all(lessThanEqual(abs(_376 - vec2(0.5)), vec2(0.5)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_81 < 65504.0) ? (1.0 - (_400.x / max(_400.y, 1.0))) : 1.0, _81, 0.0, 0.0));
}

