#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutUpsampled;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    do
    {
        vec2 _89 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _90 = _89 - vec2(1.0);
        if (any(greaterThanEqual(_90, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _102 = floor(fma(_89, vec2(0.5), vec2(-0.5)));
        vec2 _103 = max(parameters.gCoarseSize.xy, vec2(1.0));
        vec2 _104 = _103 - vec2(1.0);
        vec2 _107 = (clamp(_102, vec2(0.0), _104) + vec2(0.5)) / _103;
        vec2 _111 = (clamp(_102 + vec2(1.0), vec2(0.0), _104) + vec2(0.5)) / _103;
        vec2 _118 = _89 + vec2(-0.5);
        vec2 _123 = (floor(fma(_118, vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _127 = textureGather(gInFiltered, _123);
        float _128 = _127.w;
        float _129 = _127.z;
        float _130 = _127.x;
        float _131 = _127.y;
        float _134 = float(abs(_128) <= 65504.0);
        float _136 = (_134 > 0.5) ? _128 : 0.0;
        float _139 = float(abs(_129) <= 65504.0);
        float _141 = (_139 > 0.5) ? _129 : 0.0;
        float _144 = float(abs(_130) <= 65504.0);
        float _146 = (_144 > 0.5) ? _130 : 0.0;
        float _149 = float(abs(_131) <= 65504.0);
        vec4 _150 = vec4(_134, _139, _144, _149);
        float _152 = (_149 > 0.5) ? _131 : 0.0;
        vec4 _157 = textureGather(gInCoarseDepth, _123).wzxy;
        vec4 _160 = mix(vec4(65504.0), min(_157, vec4(65504.0)), greaterThan(_157, vec4(0.0)));
        vec3 _169 = textureLod(gInNormal, (fma(_107, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec3 _175 = textureLod(gInNormal, (fma(vec2(_111.x, _107.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec3 _181 = textureLod(gInNormal, (fma(vec2(_107.x, _111.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec3 _187 = textureLod(gInNormal, (fma(_111, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec4 _192 = textureGather(gInDepth, _89 * parameters.gOutputSize.zw);
        float _193 = _192.w;
        float _203 = 1.0 / max(fma(_193, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _207 = min(parameters.gSkyDepth, 65504.0);
        vec3 _215 = textureLod(gInNormal, _118 * parameters.gOutputSize.zw, 0.0).xyz;
        float _218 = dot(_169, _215);
        float _222 = min(parameters.gContrast, 256.0);
        bool _225 = parameters.gContrast > 0.0;
        float _227 = dot(_175, _215);
        float _234 = dot(_181, _215);
        float _241 = dot(_187, _215);
        vec4 _251 = abs(vec4((abs(_193 - 0.5) <= 0.5) ? (((_203 > 0.0) && (_203 < _207)) ? _203 : 65504.0) : 65504.0) - _160);
        bvec4 _259 = greaterThan(_150 * vec4(lessThanEqual(abs(_251), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _260 = mix(vec4(0.0), (vec4(0.5625, 0.1875, 0.1875, 0.0625) * vec4(_225 ? ((_218 > 0.0) ? pow(min(abs(_218), 1.0), _222) : 0.0) : 1.0, _225 ? ((_227 > 0.0) ? pow(min(abs(_227), 1.0), _222) : 0.0) : 1.0, _225 ? ((_234 > 0.0) ? pow(min(abs(_234), 1.0), _222) : 0.0) : 1.0, _225 ? ((_241 > 0.0) ? pow(min(abs(_241), 1.0), _222) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _251), _259);
        vec4 _262 = mix(vec4(0.0), _260, greaterThan(_260, vec4(0.0)));
        float _263 = dot(_262, vec4(1.0));
        vec4 _264 = mix(vec4(1.9999999360571384930131252153835e+38), _251, _259);
        vec4 _274 = mix(vec4(0.0), _150, lessThanEqual(_264, vec4(min(min(_264.x, _264.y), min(_264.z, _264.w)))));
        vec4 _285 = mix(_274 / vec4(max(dot(_274, vec4(1.0)), 1.0)), _262 / vec4(_263), bvec4((_263 >= 1.0000000031710768509710513471353e-30) && (_263 <= 9.9999996802856924650656260769173e+37)));
        vec4 _294 = vec4(fma(_285.w, _152, fma(_285.z, _146, fma(_285.x, _136, _285.y * _141))), 0.0, 0.0, 0.0);
        float _296 = _192.z;
        float _302 = 1.0 / max(fma(_296, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec3 _311 = textureLod(gInNormal, (_89 + vec2(0.5, -0.5)) * parameters.gOutputSize.zw, 0.0).xyz;
        float _312 = dot(_169, _311);
        float _319 = dot(_175, _311);
        float _326 = dot(_181, _311);
        float _333 = dot(_187, _311);
        vec4 _343 = abs(vec4((abs(_296 - 0.5) <= 0.5) ? (((_302 > 0.0) && (_302 < _207)) ? _302 : 65504.0) : 65504.0) - _160);
        bvec4 _351 = greaterThan(_150 * vec4(lessThanEqual(abs(_343), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _352 = mix(vec4(0.0), (vec4(0.1875, 0.5625, 0.0625, 0.1875) * vec4(_225 ? ((_312 > 0.0) ? pow(min(abs(_312), 1.0), _222) : 0.0) : 1.0, _225 ? ((_319 > 0.0) ? pow(min(abs(_319), 1.0), _222) : 0.0) : 1.0, _225 ? ((_326 > 0.0) ? pow(min(abs(_326), 1.0), _222) : 0.0) : 1.0, _225 ? ((_333 > 0.0) ? pow(min(abs(_333), 1.0), _222) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _343), _351);
        vec4 _354 = mix(vec4(0.0), _352, greaterThan(_352, vec4(0.0)));
        float _355 = dot(_354, vec4(1.0));
        vec4 _356 = mix(vec4(1.9999999360571384930131252153835e+38), _343, _351);
        vec4 _366 = mix(vec4(0.0), _150, lessThanEqual(_356, vec4(min(min(_356.x, _356.y), min(_356.z, _356.w)))));
        vec4 _377 = mix(_366 / vec4(max(dot(_366, vec4(1.0)), 1.0)), _354 / vec4(_355), bvec4((_355 >= 1.0000000031710768509710513471353e-30) && (_355 <= 9.9999996802856924650656260769173e+37)));
        vec4 _386 = vec4(fma(_377.w, _152, fma(_377.z, _146, fma(_377.x, _136, _377.y * _141))), 0.0, 0.0, 0.0);
        float _388 = _192.x;
        float _394 = 1.0 / max(fma(_388, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec3 _403 = textureLod(gInNormal, (_89 + vec2(-0.5, 0.5)) * parameters.gOutputSize.zw, 0.0).xyz;
        float _404 = dot(_169, _403);
        float _411 = dot(_175, _403);
        float _418 = dot(_181, _403);
        float _425 = dot(_187, _403);
        vec4 _435 = abs(vec4((abs(_388 - 0.5) <= 0.5) ? (((_394 > 0.0) && (_394 < _207)) ? _394 : 65504.0) : 65504.0) - _160);
        bvec4 _443 = greaterThan(_150 * vec4(lessThanEqual(abs(_435), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _444 = mix(vec4(0.0), (vec4(0.1875, 0.0625, 0.5625, 0.1875) * vec4(_225 ? ((_404 > 0.0) ? pow(min(abs(_404), 1.0), _222) : 0.0) : 1.0, _225 ? ((_411 > 0.0) ? pow(min(abs(_411), 1.0), _222) : 0.0) : 1.0, _225 ? ((_418 > 0.0) ? pow(min(abs(_418), 1.0), _222) : 0.0) : 1.0, _225 ? ((_425 > 0.0) ? pow(min(abs(_425), 1.0), _222) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _435), _443);
        vec4 _446 = mix(vec4(0.0), _444, greaterThan(_444, vec4(0.0)));
        float _447 = dot(_446, vec4(1.0));
        vec4 _448 = mix(vec4(1.9999999360571384930131252153835e+38), _435, _443);
        vec4 _458 = mix(vec4(0.0), _150, lessThanEqual(_448, vec4(min(min(_448.x, _448.y), min(_448.z, _448.w)))));
        vec4 _469 = mix(_458 / vec4(max(dot(_458, vec4(1.0)), 1.0)), _446 / vec4(_447), bvec4((_447 >= 1.0000000031710768509710513471353e-30) && (_447 <= 9.9999996802856924650656260769173e+37)));
        vec4 _478 = vec4(fma(_469.w, _152, fma(_469.z, _146, fma(_469.x, _136, _469.y * _141))), 0.0, 0.0, 0.0);
        float _480 = _192.y;
        float _486 = 1.0 / max(fma(_480, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec3 _495 = textureLod(gInNormal, (_89 + vec2(0.5)) * parameters.gOutputSize.zw, 0.0).xyz;
        float _496 = dot(_169, _495);
        float _503 = dot(_175, _495);
        float _510 = dot(_181, _495);
        float _517 = dot(_187, _495);
        vec4 _527 = abs(vec4((abs(_480 - 0.5) <= 0.5) ? (((_486 > 0.0) && (_486 < _207)) ? _486 : 65504.0) : 65504.0) - _160);
        bvec4 _535 = greaterThan(_150 * vec4(lessThanEqual(abs(_527), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _536 = mix(vec4(0.0), (vec4(0.0625, 0.1875, 0.1875, 0.5625) * vec4(_225 ? ((_496 > 0.0) ? pow(min(abs(_496), 1.0), _222) : 0.0) : 1.0, _225 ? ((_503 > 0.0) ? pow(min(abs(_503), 1.0), _222) : 0.0) : 1.0, _225 ? ((_510 > 0.0) ? pow(min(abs(_510), 1.0), _222) : 0.0) : 1.0, _225 ? ((_517 > 0.0) ? pow(min(abs(_517), 1.0), _222) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _527), _535);
        vec4 _538 = mix(vec4(0.0), _536, greaterThan(_536, vec4(0.0)));
        float _539 = dot(_538, vec4(1.0));
        vec4 _540 = mix(vec4(1.9999999360571384930131252153835e+38), _527, _535);
        vec4 _550 = mix(vec4(0.0), _150, lessThanEqual(_540, vec4(min(min(_540.x, _540.y), min(_540.z, _540.w)))));
        vec4 _561 = mix(_550 / vec4(max(dot(_550, vec4(1.0)), 1.0)), _538 / vec4(_539), bvec4((_539 >= 1.0000000031710768509710513471353e-30) && (_539 <= 9.9999996802856924650656260769173e+37)));
        vec4 _570 = vec4(fma(_561.w, _152, fma(_561.z, _146, fma(_561.x, _136, _561.y * _141))), 0.0, 0.0, 0.0);
        bvec2 _571 = greaterThanEqual(_90, vec2(0.0));
        bvec2 _572 = lessThan(_89, parameters.gOutputSize.xy);
        ivec2 _573 = ivec2(_90);
        if (all(_571) && all(_572))
        {
            imageStore(gOutUpsampled, _573, _294);
            imageStore(gOutUpsampled, _573 + ivec2(1, 0), _386);
            imageStore(gOutUpsampled, _573 + ivec2(0, 1), _478);
            imageStore(gOutUpsampled, _573 + ivec2(1), _570);
            break;
        }
        bool _586 = _571.x;
        bool _587 = _571.y;
        if (_586 && _587)
        {
            imageStore(gOutUpsampled, _573, _294);
        }
        bool _592 = _572.x;
        if (_592 && _587)
        {
            imageStore(gOutUpsampled, _573 + ivec2(1, 0), _386);
        }
        bool _598 = _572.y;
        if (_586 && _598)
        {
            imageStore(gOutUpsampled, _573 + ivec2(0, 1), _478);
        }
        if (_592 && _598)
        {
            imageStore(gOutUpsampled, _573 + ivec2(1), _570);
        }
        break;
    } while(false);
}

