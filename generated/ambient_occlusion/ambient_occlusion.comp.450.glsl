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
        vec3 _137 = vec3(fma(_91 * parameters.gOutputSize.zw, parameters.gViewRay.xy, parameters.gViewRay.zw) * _108, _108);
        vec2 _140 = vec2(parameters.gOutputSize.z, 0.0);
        vec2 _142 = fma(_91, parameters.gOutputSize.zw, -_140);
        vec2 _150 = fma(_91, parameters.gOutputSize.zw, _140);
        vec2 _175 = vec2(0.0, parameters.gOutputSize.w);
        vec2 _177 = fma(_91, parameters.gOutputSize.zw, -_175);
        vec2 _185 = fma(_91, parameters.gOutputSize.zw, _175);
        vec3 _208 = cross(mix(vec3(fma(_150, parameters.gViewRay.xy, parameters.gViewRay.zw) * _123, _123) - _137, _137 - vec3(fma(_142, parameters.gViewRay.xy, parameters.gViewRay.zw) * _113, _113), bvec3((all(lessThanEqual(abs(_142 - vec2(0.5)), vec2(0.5))) ? abs(_113 - _108) : 131008.0) < (all(lessThanEqual(abs(_150 - vec2(0.5)), vec2(0.5))) ? abs(_123 - _108) : 65504.0))), mix(vec3(fma(_185, parameters.gViewRay.xy, parameters.gViewRay.zw) * _128, _128) - _137, _137 - vec3(fma(_177, parameters.gViewRay.xy, parameters.gViewRay.zw) * _118, _118), bvec3((all(lessThanEqual(abs(_177 - vec2(0.5)), vec2(0.5))) ? abs(_118 - _108) : 131008.0) < (all(lessThanEqual(abs(_185 - vec2(0.5)), vec2(0.5))) ? abs(_128 - _108) : 65504.0))));
        vec3 _218 = normalize(mix(-_208, _208, bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0)));
        vec2 _219 = floor(_91);
        float _224 = floor(parameters.gSubsetCount);
        float _227 = (_224 > 1.0) ? min(_224, 16.0) : 1.0;
        float _231 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec3 _237 = vec3(0.276690065860748291015625, 0.68417441844940185546875, 0.1988019049167633056640625) * fma(-_227, floor((_231 + 0.5) / _227), _231);
        vec2 _240 = floor(_219 * 0.5);
        vec2 _242 = _219 - (_240 * 2.0);
        vec2 _246 = _240 - (floor(_219 * 0.25) * 2.0);
        float _248 = _242.y;
        float _251 = _246.y;
        vec2 _257 = (abs(vec2(_242.x - _248, _246.x - _251)) * 2.0) + vec2(_248, _251);
        float _262 = 6.283185482025146484375 * fma(fma(4.0, _257.x, _257.y), 0.0625, _237.x);
        float _263 = cos(_262);
        float _264 = sin(_262);
        vec2 _269 = vec2(_219.y + 1.0, _219.x);
        vec2 _271 = floor(_269 * 0.5);
        vec2 _273 = _269 - (_271 * 2.0);
        vec2 _277 = _271 - (floor(_269 * 0.25) * 2.0);
        float _279 = _273.y;
        float _282 = _277.y;
        vec2 _288 = (abs(vec2(_273.x - _279, _277.x - _282)) * 2.0) + vec2(_279, _282);
        float _292 = fma(fma(4.0, _288.x, _288.y), 0.0625, _237.z);
        float _298 = max(fma(parameters.gBias.y, _108, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
        float _299 = _218.z;
        float _301 = (_299 >= 0.0) ? 1.0 : (-1.0);
        float _303 = (-1.0) / (_301 + _299);
        float _304 = _218.x;
        float _305 = _218.y;
        float _307 = (_304 * _305) * _303;
        vec3 _314 = vec3(fma((_301 * _304) * _304, _303, 1.0), _301 * _307, (-_301) * _304);
        vec3 _318 = vec3(_307, fma(_305 * _305, _303, _301), -_305);
        vec3 _319 = fract(vec3(0.5));
        float _321 = 6.283185482025146484375 * _319.x;
        float _322 = cos(_321);
        float _323 = sin(_321);
        float _331 = _237.y;
        float _333 = fract(_319.y + _331);
        vec2 _335 = vec2(fma(_322, _263, -(_323 * _264)), fma(_322, _264, _323 * _263)) * sqrt(_333);
        vec3 _353 = _137 + ((((_314 * _335.x) + (_318 * _335.y)) + (_218 * sqrt(1.0 - _333))) * (parameters.gRadius * sqrt(fract(_319.z + _292))));
        float _355 = _353.z;
        vec2 _359 = ((_353.xy / vec2(_355)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _367 = textureLod(gInCoarseDepth, _359, 0.0);
        float _368 = _367.x;
        float _370 = (_368 > 0.0) ? _368 : 65504.0;
        float _373 = _355 - ((_370 < 65504.0) ? _370 : 65504.0);
        vec3 _384 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
        float _386 = 6.283185482025146484375 * _384.x;
        float _387 = cos(_386);
        float _388 = sin(_386);
        float _397 = fract(_384.y + _331);
        vec2 _399 = vec2(fma(_387, _263, -(_388 * _264)), fma(_387, _264, _388 * _263)) * sqrt(_397);
        vec3 _415 = _137 + ((((_314 * _399.x) + (_318 * _399.y)) + (_218 * sqrt(1.0 - _397))) * (parameters.gRadius * sqrt(fract(_384.z + _292))));
        float _417 = _415.z;
        vec2 _421 = ((_415.xy / vec2(_417)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _429 = textureLod(gInCoarseDepth, _421, 0.0);
        float _430 = _429.x;
        float _432 = (_430 > 0.0) ? _430 : 65504.0;
        float _435 = _417 - ((_432 < 65504.0) ? _432 : 65504.0);
        vec3 _447 = fract(vec3(2.1383450031280517578125, 1.842087268829345703125, 1.599400997161865234375));
        float _449 = 6.283185482025146484375 * _447.x;
        float _450 = cos(_449);
        float _451 = sin(_449);
        float _460 = fract(_447.y + _331);
        vec2 _462 = vec2(fma(_450, _263, -(_451 * _264)), fma(_450, _264, _451 * _263)) * sqrt(_460);
        vec3 _478 = _137 + ((((_314 * _462.x) + (_318 * _462.y)) + (_218 * sqrt(1.0 - _460))) * (parameters.gRadius * sqrt(fract(_447.z + _292))));
        float _480 = _478.z;
        vec2 _484 = ((_478.xy / vec2(_480)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _492 = textureLod(gInCoarseDepth, _484, 0.0);
        float _493 = _492.x;
        float _495 = (_493 > 0.0) ? _493 : 65504.0;
        float _498 = _480 - ((_495 < 65504.0) ? _495 : 65504.0);
        vec3 _510 = fract(vec3(2.9575176239013671875, 2.5131309032440185546875, 2.1491014957427978515625));
        float _512 = 6.283185482025146484375 * _510.x;
        float _513 = cos(_512);
        float _514 = sin(_512);
        float _523 = fract(_510.y + _331);
        vec2 _525 = vec2(fma(_513, _263, -(_514 * _264)), fma(_513, _264, _514 * _263)) * sqrt(_523);
        vec3 _541 = _137 + ((((_314 * _525.x) + (_318 * _525.y)) + (_218 * sqrt(1.0 - _523))) * (parameters.gRadius * sqrt(fract(_510.z + _292))));
        float _543 = _541.z;
        vec2 _547 = ((_541.xy / vec2(_543)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _555 = textureLod(gInCoarseDepth, _547, 0.0);
        float _556 = _555.x;
        float _558 = (_556 > 0.0) ? _556 : 65504.0;
        float _561 = _543 - ((_558 < 65504.0) ? _558 : 65504.0);
        vec2 _572 = ((mix(vec2(0.0), vec2(clamp((_373 / _298) - 1.0, 0.0, 1.0) * clamp(2.0 - (_373 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_355 > 0.0) && all(lessThanEqual(abs(_359 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_435 / _298) - 1.0, 0.0, 1.0) * clamp(2.0 - (_435 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_417 > 0.0) && all(lessThanEqual(abs(_421 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_498 / _298) - 1.0, 0.0, 1.0) * clamp(2.0 - (_498 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_480 > 0.0) && all(lessThanEqual(abs(_484 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_561 / _298) - 1.0, 0.0, 1.0) * clamp(2.0 - (_561 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_543 > 0.0) && all(lessThanEqual(abs(_547 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_572.x / max(_572.y, 1.0)), _108), bvec2(_108 < 65504.0)), 0.0, 0.0));
        break;
    } while(false);
}

