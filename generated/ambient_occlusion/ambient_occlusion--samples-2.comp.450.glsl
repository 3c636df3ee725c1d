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
        vec2 _83 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _89 = parameters.gOutputSize.zw * 0.5;
        vec4 _92 = textureGather(gInCoarseDepth, fma(_83, parameters.gOutputSize.zw, -_89));
        vec4 _95 = textureGather(gInCoarseDepth, fma(_83, parameters.gOutputSize.zw, _89));
        float _96 = _92.y;
        float _98 = (_96 > 0.0) ? _96 : 65504.0;
        float _100 = (_98 < 65504.0) ? _98 : 65504.0;
        float _101 = _92.x;
        float _103 = (_101 > 0.0) ? _101 : 65504.0;
        float _105 = (_103 < 65504.0) ? _103 : 65504.0;
        float _106 = _92.z;
        float _108 = (_106 > 0.0) ? _106 : 65504.0;
        float _110 = (_108 < 65504.0) ? _108 : 65504.0;
        float _111 = _95.z;
        float _113 = (_111 > 0.0) ? _111 : 65504.0;
        float _115 = (_113 < 65504.0) ? _113 : 65504.0;
        float _116 = _95.x;
        float _118 = (_116 > 0.0) ? _116 : 65504.0;
        float _120 = (_118 < 65504.0) ? _118 : 65504.0;
        vec3 _129 = vec3(fma(_83 * parameters.gOutputSize.zw, parameters.gViewRay.xy, parameters.gViewRay.zw) * _100, _100);
        vec2 _132 = vec2(parameters.gOutputSize.z, 0.0);
        vec2 _134 = fma(_83, parameters.gOutputSize.zw, -_132);
        vec2 _142 = fma(_83, parameters.gOutputSize.zw, _132);
        vec2 _167 = vec2(0.0, parameters.gOutputSize.w);
        vec2 _169 = fma(_83, parameters.gOutputSize.zw, -_167);
        vec2 _177 = fma(_83, parameters.gOutputSize.zw, _167);
        vec3 _200 = cross(mix(vec3(fma(_142, parameters.gViewRay.xy, parameters.gViewRay.zw) * _115, _115) - _129, _129 - vec3(fma(_134, parameters.gViewRay.xy, parameters.gViewRay.zw) * _105, _105), bvec3((all(lessThanEqual(abs(_134 - vec2(0.5)), vec2(0.5))) ? abs(_105 - _100) : 131008.0) < (all(lessThanEqual(abs(_142 - vec2(0.5)), vec2(0.5))) ? abs(_115 - _100) : 65504.0))), mix(vec3(fma(_177, parameters.gViewRay.xy, parameters.gViewRay.zw) * _120, _120) - _129, _129 - vec3(fma(_169, parameters.gViewRay.xy, parameters.gViewRay.zw) * _110, _110), bvec3((all(lessThanEqual(abs(_169 - vec2(0.5)), vec2(0.5))) ? abs(_110 - _100) : 131008.0) < (all(lessThanEqual(abs(_177 - vec2(0.5)), vec2(0.5))) ? abs(_120 - _100) : 65504.0))));
        vec3 _210 = normalize(mix(-_200, _200, bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0)));
        vec2 _211 = floor(_83);
        float _216 = floor(parameters.gSubsetCount);
        float _219 = (_216 > 1.0) ? min(_216, 16.0) : 1.0;
        float _223 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec3 _229 = vec3(0.6383450031280517578125, 0.342087209224700927734375, 0.09940095245838165283203125) * fma(-_219, floor((_223 + 0.5) / _219), _223);
        vec2 _232 = floor(_211 * 0.5);
        vec2 _234 = _211 - (_232 * 2.0);
        vec2 _238 = _232 - (floor(_211 * 0.25) * 2.0);
        float _240 = _234.y;
        float _243 = _238.y;
        vec2 _249 = (abs(vec2(_234.x - _240, _238.x - _243)) * 2.0) + vec2(_240, _243);
        float _254 = 6.283185482025146484375 * fma(fma(4.0, _249.x, _249.y), 0.0625, _229.x);
        float _255 = cos(_254);
        float _256 = sin(_254);
        vec2 _261 = vec2(_211.y + 1.0, _211.x);
        vec2 _263 = floor(_261 * 0.5);
        vec2 _265 = _261 - (_263 * 2.0);
        vec2 _269 = _263 - (floor(_261 * 0.25) * 2.0);
        float _271 = _265.y;
        float _274 = _269.y;
        vec2 _280 = (abs(vec2(_265.x - _271, _269.x - _274)) * 2.0) + vec2(_271, _274);
        float _284 = fma(fma(4.0, _280.x, _280.y), 0.0625, _229.z);
        float _290 = max(fma(parameters.gBias.y, _100, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
        float _291 = _210.z;
        float _293 = (_291 >= 0.0) ? 1.0 : (-1.0);
        float _295 = (-1.0) / (_293 + _291);
        float _296 = _210.x;
        float _297 = _210.y;
        float _299 = (_296 * _297) * _295;
        vec3 _306 = vec3(fma((_293 * _296) * _296, _295, 1.0), _293 * _299, (-_293) * _296);
        vec3 _310 = vec3(_299, fma(_297 * _297, _295, _293), -_297);
        vec3 _311 = fract(vec3(0.5));
        float _313 = 6.283185482025146484375 * _311.x;
        float _314 = cos(_313);
        float _315 = sin(_313);
        float _323 = _229.y;
        float _325 = fract(_311.y + _323);
        vec2 _327 = vec2(fma(_314, _255, -(_315 * _256)), fma(_314, _256, _315 * _255)) * sqrt(_325);
        vec3 _345 = _129 + ((((_306 * _327.x) + (_310 * _327.y)) + (_210 * sqrt(1.0 - _325))) * (parameters.gRadius * sqrt(fract(_311.z + _284))));
        float _347 = _345.z;
        vec2 _351 = ((_345.xy / vec2(_347)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _359 = textureLod(gInCoarseDepth, _351, 0.0);
        float _360 = _359.x;
        float _362 = (_360 > 0.0) ? _360 : 65504.0;
        float _365 = _347 - ((_362 < 65504.0) ? _362 : 65504.0);
        vec3 _376 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
        float _378 = 6.283185482025146484375 * _376.x;
        float _379 = cos(_378);
        float _380 = sin(_378);
        float _389 = fract(_376.y + _323);
        vec2 _391 = vec2(fma(_379, _255, -(_380 * _256)), fma(_379, _256, _380 * _255)) * sqrt(_389);
        vec3 _407 = _129 + ((((_306 * _391.x) + (_310 * _391.y)) + (_210 * sqrt(1.0 - _389))) * (parameters.gRadius * sqrt(fract(_376.z + _284))));
        float _409 = _407.z;
        vec2 _413 = ((_407.xy / vec2(_409)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _421 = textureLod(gInCoarseDepth, _413, 0.0);
        float _422 = _421.x;
        float _424 = (_422 > 0.0) ? _422 : 65504.0;
        float _427 = _409 - ((_424 < 65504.0) ? _424 : 65504.0);
        vec2 _438 = mix(vec2(0.0), vec2(clamp((_365 / _290) - 1.0, 0.0, 1.0) * clamp(2.0 - (_365 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_347 > 0.0) && all(lessThanEqual(abs(_351 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_427 / _290) - 1.0, 0.0, 1.0) * clamp(2.0 - (_427 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_409 > 0.0) && all(lessThanEqual(abs(_413 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_438.x / max(_438.y, 1.0)), _100), bvec2(_100 < 65504.0)), 0.0, 0.0));
        break;
    } while(false);
}

