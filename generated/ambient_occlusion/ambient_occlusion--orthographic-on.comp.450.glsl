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
        vec2 _91 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _97 = parameters.gOutputSize.zw * 0.5;
        vec4 _100 = textureGather(gInCoarseDepth, fma(_91, parameters.gOutputSize.zw, -_97));
        vec4 _103 = textureGather(gInCoarseDepth, fma(_91, parameters.gOutputSize.zw, _97));
        float _104 = _100.y;
        float _106 = (_104 > 0.0) ? _104 : 65504.0;
        float _108 = (_106 < 65504.0) ? _106 : 65504.0;
        float _109 = _100.x;
        float _111 = (_109 > 0.0) ? _109 : 65504.0;
        float _113 = (_111 < 65504.0) ? _111 : 65504.0;
        float _114 = _100.z;
        float _116 = (_114 > 0.0) ? _114 : 65504.0;
        float _118 = (_116 < 65504.0) ? _116 : 65504.0;
        float _119 = _103.z;
        float _121 = (_119 > 0.0) ? _119 : 65504.0;
        float _123 = (_121 < 65504.0) ? _121 : 65504.0;
        float _124 = _103.x;
        float _126 = (_124 > 0.0) ? _124 : 65504.0;
        float _128 = (_126 < 65504.0) ? _126 : 65504.0;
        vec3 _136 = vec3(fma(_91 * parameters.gOutputSize.zw, parameters.gViewRay.xy, parameters.gViewRay.zw), _108);
        vec2 _139 = vec2(parameters.gOutputSize.z, 0.0);
        vec2 _141 = fma(_91, parameters.gOutputSize.zw, -_139);
        vec2 _149 = fma(_91, parameters.gOutputSize.zw, _139);
        vec2 _172 = vec2(0.0, parameters.gOutputSize.w);
        vec2 _174 = fma(_91, parameters.gOutputSize.zw, -_172);
        vec2 _182 = fma(_91, parameters.gOutputSize.zw, _172);
        vec3 _203 = cross(mix(vec3(fma(_149, parameters.gViewRay.xy, parameters.gViewRay.zw), _123) - _136, _136 - vec3(fma(_141, parameters.gViewRay.xy, parameters.gViewRay.zw), _113), bvec3((all(lessThanEqual(abs(_141 - vec2(0.5)), vec2(0.5))) ? abs(_113 - _108) : 131008.0) < (all(lessThanEqual(abs(_149 - vec2(0.5)), vec2(0.5))) ? abs(_123 - _108) : 65504.0))), mix(vec3(fma(_182, parameters.gViewRay.xy, parameters.gViewRay.zw), _128) - _136, _136 - vec3(fma(_174, parameters.gViewRay.xy, parameters.gViewRay.zw), _118), bvec3((all(lessThanEqual(abs(_174 - vec2(0.5)), vec2(0.5))) ? abs(_118 - _108) : 131008.0) < (all(lessThanEqual(abs(_182 - vec2(0.5)), vec2(0.5))) ? abs(_128 - _108) : 65504.0))));
        vec3 _213 = normalize(mix(-_203, _203, bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0)));
        vec2 _214 = floor(_91);
        float _219 = floor(parameters.gSubsetCount);
        float _222 = (_219 > 1.0) ? min(_219, 16.0) : 1.0;
        float _226 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec3 _232 = vec3(0.276690065860748291015625, 0.68417441844940185546875, 0.1988019049167633056640625) * fma(-_222, floor((_226 + 0.5) / _222), _226);
        vec2 _235 = floor(_214 * 0.5);
        vec2 _237 = _214 - (_235 * 2.0);
        vec2 _241 = _235 - (floor(_214 * 0.25) * 2.0);
        float _243 = _237.y;
        float _246 = _241.y;
        vec2 _252 = (abs(vec2(_237.x - _243, _241.x - _246)) * 2.0) + vec2(_243, _246);
        float _257 = 6.283185482025146484375 * fma(fma(4.0, _252.x, _252.y), 0.0625, _232.x);
        float _258 = cos(_257);
        float _259 = sin(_257);
        vec2 _264 = vec2(_214.y + 1.0, _214.x);
        vec2 _266 = floor(_264 * 0.5);
        vec2 _268 = _264 - (_266 * 2.0);
        vec2 _272 = _266 - (floor(_264 * 0.25) * 2.0);
        float _274 = _268.y;
        float _277 = _272.y;
        vec2 _283 = (abs(vec2(_268.x - _274, _272.x - _277)) * 2.0) + vec2(_274, _277);
        float _287 = fma(fma(4.0, _283.x, _283.y), 0.0625, _232.z);
        float _293 = max(fma(parameters.gBias.y, _108, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
        float _294 = _213.z;
        float _296 = (_294 >= 0.0) ? 1.0 : (-1.0);
        float _298 = (-1.0) / (_296 + _294);
        float _299 = _213.x;
        float _300 = _213.y;
        float _302 = (_299 * _300) * _298;
        vec3 _309 = vec3(fma((_296 * _299) * _299, _298, 1.0), _296 * _302, (-_296) * _299);
        vec3 _313 = vec3(_302, fma(_300 * _300, _298, _296), -_300);
        vec3 _314 = fract(vec3(0.5));
        float _316 = 6.283185482025146484375 * _314.x;
        float _317 = cos(_316);
        float _318 = sin(_316);
        float _326 = _232.y;
        float _328 = fract(_314.y + _326);
        vec2 _330 = vec2(fma(_317, _258, -(_318 * _259)), fma(_317, _259, _318 * _258)) * sqrt(_328);
        vec3 _348 = _136 + ((((_309 * _330.x) + (_313 * _330.y)) + (_213 * sqrt(1.0 - _328))) * (parameters.gRadius * sqrt(fract(_314.z + _287))));
        vec2 _351 = (_348.xy - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        float _352 = _348.z;
        vec4 _360 = textureLod(gInCoarseDepth, _351, 0.0);
        float _361 = _360.x;
        float _363 = (_361 > 0.0) ? _361 : 65504.0;
        float _366 = _352 - ((_363 < 65504.0) ? _363 : 65504.0);
        vec3 _377 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
        float _379 = 6.283185482025146484375 * _377.x;
        float _380 = cos(_379);
        float _381 = sin(_379);
        float _390 = fract(_377.y + _326);
        vec2 _392 = vec2(fma(_380, _258, -(_381 * _259)), fma(_380, _259, _381 * _258)) * sqrt(_390);
        vec3 _408 = _136 + ((((_309 * _392.x) + (_313 * _392.y)) + (_213 * sqrt(1.0 - _390))) * (parameters.gRadius * sqrt(fract(_377.z + _287))));
        vec2 _411 = (_408.xy - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        float _412 = _408.z;
        vec4 _420 = textureLod(gInCoarseDepth, _411, 0.0);
        float _421 = _420.x;
        float _423 = (_421 > 0.0) ? _421 : 65504.0;
        float _426 = _412 - ((_423 < 65504.0) ? _423 : 65504.0);
        vec3 _438 = fract(vec3(2.1383450031280517578125, 1.842087268829345703125, 1.599400997161865234375));
        float _440 = 6.283185482025146484375 * _438.x;
        float _441 = cos(_440);
        float _442 = sin(_440);
        float _451 = fract(_438.y + _326);
        vec2 _453 = vec2(fma(_441, _258, -(_442 * _259)), fma(_441, _259, _442 * _258)) * sqrt(_451);
        vec3 _469 = _136 + ((((_309 * _453.x) + (_313 * _453.y)) + (_213 * sqrt(1.0 - _451))) * (parameters.gRadius * sqrt(fract(_438.z + _287))));
        vec2 _472 = (_469.xy - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        float _473 = _469.z;
        vec4 _481 = textureLod(gInCoarseDepth, _472, 0.0);
        float _482 = _481.x;
        float _484 = (_482 > 0.0) ? _482 : 65504.0;
        float _487 = _473 - ((_484 < 65504.0) ? _484 : 65504.0);
        vec3 _499 = fract(vec3(2.9575176239013671875, 2.5131309032440185546875, 2.1491014957427978515625));
        float _501 = 6.283185482025146484375 * _499.x;
        float _502 = cos(_501);
        float _503 = sin(_501);
        float _512 = fract(_499.y + _326);
        vec2 _514 = vec2(fma(_502, _258, -(_503 * _259)), fma(_502, _259, _503 * _258)) * sqrt(_512);
        vec3 _530 = _136 + ((((_309 * _514.x) + (_313 * _514.y)) + (_213 * sqrt(1.0 - _512))) * (parameters.gRadius * sqrt(fract(_499.z + _287))));
        vec2 _533 = (_530.xy - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        float _534 = _530.z;
        vec4 _542 = textureLod(gInCoarseDepth, _533, 0.0);
        float _543 = _542.x;
        float _545 = (_543 > 0.0) ? _543 : 65504.0;
        float _548 = _534 - ((_545 < 65504.0) ? _545 : 65504.0);
        vec2 _559 = ((mix(vec2(0.0), vec2(clamp((_366 / _293) - 1.0, 0.0, 1.0) * clamp(2.0 - (_366 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_352 > 0.0) && all(lessThanEqual(abs(_351 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_426 / _293) - 1.0, 0.0, 1.0) * clamp(2.0 - (_426 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_412 > 0.0) && all(lessThanEqual(abs(_411 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_487 / _293) - 1.0, 0.0, 1.0) * clamp(2.0 - (_487 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_473 > 0.0) && all(lessThanEqual(abs(_472 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_548 / _293) - 1.0, 0.0, 1.0) * clamp(2.0 - (_548 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_534 > 0.0) && all(lessThanEqual(abs(_533 - vec2(0.5)), vec2(0.5)))));
        vec2 _568 = mix(vec2(1.0, 65504.0), vec2(1.0 - (_559.x / max(_559.y, 1.0)), _108), bvec2(_108 < 65504.0));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4(_568, 0.0, 0.0));
        break;
    } while(false);
}

