#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gFrameIndex;
    float gSubsetCount;
    vec2 gBias;
    vec2 gFrameToCoarse;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutOcclusion;
layout(binding = 1) uniform sampler2D gInCoarseDepth;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _79 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _85 = parameters.gOutputSize.zw * 0.5;
        vec4 _88 = textureGather(gInCoarseDepth, fma(_79, parameters.gOutputSize.zw, -_85));
        vec4 _91 = textureGather(gInCoarseDepth, fma(_79, parameters.gOutputSize.zw, _85));
        float _92 = _88.y;
        float _94 = (_92 > 0.0) ? _92 : 65504.0;
        float _96 = (_94 < 65504.0) ? _94 : 65504.0;
        float _97 = _88.x;
        float _99 = (_97 > 0.0) ? _97 : 65504.0;
        float _101 = (_99 < 65504.0) ? _99 : 65504.0;
        float _102 = _88.z;
        float _104 = (_102 > 0.0) ? _102 : 65504.0;
        float _106 = (_104 < 65504.0) ? _104 : 65504.0;
        float _107 = _91.z;
        float _109 = (_107 > 0.0) ? _107 : 65504.0;
        float _111 = (_109 < 65504.0) ? _109 : 65504.0;
        float _112 = _91.x;
        float _114 = (_112 > 0.0) ? _112 : 65504.0;
        float _116 = (_114 < 65504.0) ? _114 : 65504.0;
        vec3 _125 = vec3(fma(_79 * parameters.gOutputSize.zw, parameters.gViewRay.xy, parameters.gViewRay.zw) * _96, _96);
        vec2 _128 = vec2(parameters.gOutputSize.z, 0.0);
        vec2 _130 = fma(_79, parameters.gOutputSize.zw, -_128);
        vec2 _138 = fma(_79, parameters.gOutputSize.zw, _128);
        vec2 _163 = vec2(0.0, parameters.gOutputSize.w);
        vec2 _165 = fma(_79, parameters.gOutputSize.zw, -_163);
        vec2 _173 = fma(_79, parameters.gOutputSize.zw, _163);
        vec3 _196 = cross(mix(vec3(fma(_138, parameters.gViewRay.xy, parameters.gViewRay.zw) * _111, _111) - _125, _125 - vec3(fma(_130, parameters.gViewRay.xy, parameters.gViewRay.zw) * _101, _101), bvec3((all(lessThanEqual(abs(_130 - vec2(0.5)), vec2(0.5))) ? abs(_101 - _96) : 131008.0) < (all(lessThanEqual(abs(_138 - vec2(0.5)), vec2(0.5))) ? abs(_111 - _96) : 65504.0))), mix(vec3(fma(_173, parameters.gViewRay.xy, parameters.gViewRay.zw) * _116, _116) - _125, _125 - vec3(fma(_165, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106), bvec3((all(lessThanEqual(abs(_165 - vec2(0.5)), vec2(0.5))) ? abs(_106 - _96) : 131008.0) < (all(lessThanEqual(abs(_173 - vec2(0.5)), vec2(0.5))) ? abs(_116 - _96) : 65504.0))));
        vec3 _206 = normalize(mix(-_196, _196, bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0)));
        vec2 _207 = floor(_79);
        float _212 = floor(parameters.gSubsetCount);
        float _215 = (_212 > 1.0) ? min(_212, 16.0) : 1.0;
        float _219 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec3 _225 = vec3(0.81917250156402587890625, 0.6710436344146728515625, 0.5497004985809326171875) * fma(-_215, floor((_219 + 0.5) / _215), _219);
        vec2 _228 = floor(_207 * 0.5);
        vec2 _230 = _207 - (_228 * 2.0);
        vec2 _234 = _228 - (floor(_207 * 0.25) * 2.0);
        float _236 = _230.y;
        float _239 = _234.y;
        vec2 _245 = (abs(vec2(_230.x - _236, _234.x - _239)) * 2.0) + vec2(_236, _239);
        float _250 = 6.283185482025146484375 * fma(fma(4.0, _245.x, _245.y), 0.0625, _225.x);
        float _251 = cos(_250);
        float _252 = sin(_250);
        vec2 _257 = vec2(_207.y + 1.0, _207.x);
        vec2 _259 = floor(_257 * 0.5);
        vec2 _261 = _257 - (_259 * 2.0);
        vec2 _265 = _259 - (floor(_257 * 0.25) * 2.0);
        float _267 = _261.y;
        float _270 = _265.y;
        vec2 _276 = (abs(vec2(_261.x - _267, _265.x - _270)) * 2.0) + vec2(_267, _270);
        float _287 = _206.z;
        float _289 = (_287 >= 0.0) ? 1.0 : (-1.0);
        float _291 = (-1.0) / (_289 + _287);
        float _292 = _206.x;
        float _293 = _206.y;
        float _295 = (_292 * _293) * _291;
        vec3 _307 = fract(vec3(0.5));
        float _309 = 6.283185482025146484375 * _307.x;
        float _310 = cos(_309);
        float _311 = sin(_309);
        float _321 = fract(_307.y + _225.y);
        vec2 _323 = vec2(fma(_310, _251, -(_311 * _252)), fma(_310, _252, _311 * _251)) * sqrt(_321);
        vec3 _341 = _125 + ((((vec3(fma((_289 * _292) * _292, _291, 1.0), _289 * _295, (-_289) * _292) * _323.x) + (vec3(_295, fma(_293 * _293, _291, _289), -_293) * _323.y)) + (_206 * sqrt(1.0 - _321))) * (parameters.gRadius * sqrt(fract(_307.z + fma(fma(4.0, _276.x, _276.y), 0.0625, _225.z)))));
        float _343 = _341.z;
        vec2 _347 = ((_341.xy / vec2(_343)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _355 = textureLod(gInCoarseDepth, _347, 0.0);
        float _356 = _355.x;
        float _358 = (_356 > 0.0) ? _356 : 65504.0;
        float _361 = _343 - ((_358 < 65504.0) ? _358 : 65504.0);
        vec2 _371 = mix(vec2(0.0), vec2(clamp((_361 / max(fma(parameters.gBias.y, _96, parameters.gBias.x), 9.9999999747524270787835121154785e-07)) - 1.0, 0.0, 1.0) * clamp(2.0 - (_361 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_343 > 0.0) && all(lessThanEqual(abs(_347 - vec2(0.5)), vec2(0.5)))));
        vec2 _380 = mix(vec2(1.0, 65504.0), vec2(1.0 - (_371.x / max(_371.y, 1.0)), _96), bvec2(_96 < 65504.0));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4(_380, 0.0, 0.0));
        break;
    } while(false);
}

