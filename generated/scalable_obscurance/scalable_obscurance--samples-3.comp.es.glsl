#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

float _113;
float _114;

layout(binding = 0, std140) uniform ScalableObscuranceParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gIntensity;
    vec2 gBias;
    float gFrameIndex;
    float gRotationCount;
    float gFarDepth;
    float gMaxWeight;
    vec2 gMissThreshold;
    vec2 gMotionToUv;
    vec4 gViewToPreviousDepth;
    float gHistoryValid;
} parameters;

layout(binding = 16, rgba8) uniform writeonly highp image2D gOutObscurance;
layout(binding = 1) uniform highp sampler2D gInDepthHierarchy;
layout(binding = 2) uniform highp sampler2D gInVelocity;
layout(binding = 3) uniform highp sampler2D gHistoryObscurance;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _129 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _131 = _129 * parameters.gOutputSize.zw;
        vec2 _139 = vec2(1.0 / ceil(1.5 * parameters.gOutputSize.x), parameters.gOutputSize.w);
        vec2 _143 = _139 * 0.5;
        vec4 _146 = textureGather(gInDepthHierarchy, _129 * _139 + (-_143));
        vec4 _149 = textureGather(gInDepthHierarchy, _129 * _139 + _143);
        float _150 = _146.y;
        float _152 = (_150 > 0.0) ? _150 : 65504.0;
        float _154 = (_152 < 65504.0) ? _152 : 65504.0;
        float _155 = _146.x;
        float _157 = (_155 > 0.0) ? _155 : 65504.0;
        float _159 = (_157 < 65504.0) ? _157 : 65504.0;
        float _160 = _146.z;
        float _162 = (_160 > 0.0) ? _160 : 65504.0;
        float _164 = (_162 < 65504.0) ? _162 : 65504.0;
        float _165 = _149.z;
        float _167 = (_165 > 0.0) ? _165 : 65504.0;
        float _169 = (_167 < 65504.0) ? _167 : 65504.0;
        float _170 = _149.x;
        float _172 = (_170 > 0.0) ? _170 : 65504.0;
        float _174 = (_172 < 65504.0) ? _172 : 65504.0;
        vec2 _180 = (_131 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _154;
        float _181 = _180.x;
        vec3 _183 = vec3(_181, _180.y, _154);
        vec2 _186 = vec2(parameters.gOutputSize.z, 0.0);
        vec2 _188 = _129 * parameters.gOutputSize.zw + (-_186);
        vec2 _196 = _129 * parameters.gOutputSize.zw + _186;
        float _203 = all(lessThanEqual(abs(_196 - vec2(0.5)), vec2(0.5))) ? abs(_169 - _154) : 65504.0;
        float _205 = (_203 < 65504.0) ? _169 : _154;
        vec2 _221 = vec2(0.0, parameters.gOutputSize.w);
        vec2 _223 = _129 * parameters.gOutputSize.zw + (-_221);
        vec2 _231 = _129 * parameters.gOutputSize.zw + _221;
        float _238 = all(lessThanEqual(abs(_231 - vec2(0.5)), vec2(0.5))) ? abs(_174 - _154) : 65504.0;
        float _240 = (_238 < 65504.0) ? _174 : _154;
        vec3 _264 = cross(mix(vec3((_196 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _205, _205) - _183, _183 - vec3((_188 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _159, _159), bvec3((all(lessThanEqual(abs(_188 - vec2(0.5)), vec2(0.5))) ? abs(_159 - _154) : 131008.0) < _203)), mix(vec3((_231 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _240, _240) - _183, _183 - vec3((_223 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _164, _164), bvec3((all(lessThanEqual(abs(_223 - vec2(0.5)), vec2(0.5))) ? abs(_164 - _154) : 131008.0) < _238))) * (((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0) ? 1.0 : (-1.0));
        float _265 = dot(_264, _264);
        vec3 _270 = mix(vec3(0.0, 0.0, -1.0), _264 * inversesqrt(_265), bvec3(_265 > 1.0000000359391298238442905219083e-36));
        float _273 = floor(parameters.gRotationCount);
        float _276 = (_273 > 1.0) ? min(_273, 16.0) : 1.0;
        float _282 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        float _287 = (-_276) * floor((_282 + 0.5) / _276) + _282;
        float _291 = fract(dot(floor(_129), vec2(193.0, 146.0)) * 0.00390625);
        float _294 = 6.283185482025146484375 * fract(0.3819660246372222900390625 * _287 + _291);
        float _297 = 6.283185482025146484375 * fract(0.3819660246372222900390625 * _276);
        float _298 = cos(_294);
        float _299 = sin(_294);
        float _301 = cos(_297);
        float _302 = sin(_297);
        float _305 = (_287 + 0.5) / (3.0 * _276);
        vec2 _317 = min(((parameters.gOutputSize.xy / abs(parameters.gViewRay.xy)) / vec2(_154)) * parameters.gRadius, vec2(min(parameters.gOutputSize.x, parameters.gOutputSize.y)));
        float _320 = max(_317.x, _317.y);
        float _321 = 1.0 / parameters.gRadius;
        vec2 _328 = (_317 * _305) * vec2(_298, _299) + _129;
        float _329 = _305 * _320;
        float _337 = (_329 < 16.0) ? 1.0 : ((_329 < 32.0) ? 0.5 : ((_329 < 64.0) ? 0.25 : ((_329 < 128.0) ? 0.125 : 0.0625)));
        float _338 = 1.0 / _337;
        vec2 _344 = min(floor(_328 * _337), floor(parameters.gOutputSize.xy * _337) - vec2(1.0));
        float _346 = floor(0.25 / _337);
        vec4 _371 = textureLod(gInDepthHierarchy, ((vec2((_337 < 1.0) ? parameters.gOutputSize.x : 0.0, max(parameters.gOutputSize.y - floor((2.0 * _337) * parameters.gOutputSize.y), 0.0)) + _344) + vec2(0.5)) * _139, 0.0);
        float _372 = _371.x;
        vec3 _380 = (vec3((((((_344 * _338) + mix(vec2((_338 - 1.0) - _346), vec2(_346), fract(_344.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gOutputSize.zw) * parameters.gViewRay.xy + parameters.gViewRay.zw) * _372, _372) - _183) * _321;
        float _381 = dot(_380, _380);
        float _382 = 1.0 - _381;
        float _386 = -(parameters.gBias.y * _154 + parameters.gBias.x);
        float _403 = _298 * _301 + (-(_299 * _302));
        float _405 = _298 * _302 + (_299 * _301);
        float _407 = 0.3333333432674407958984375 + _305;
        vec2 _409 = (_317 * _407) * vec2(_403, _405) + _129;
        float _410 = _407 * _320;
        float _418 = (_410 < 16.0) ? 1.0 : ((_410 < 32.0) ? 0.5 : ((_410 < 64.0) ? 0.25 : ((_410 < 128.0) ? 0.125 : 0.0625)));
        float _419 = 1.0 / _418;
        vec2 _425 = min(floor(_409 * _418), floor(parameters.gOutputSize.xy * _418) - vec2(1.0));
        float _427 = floor(0.25 / _418);
        vec4 _452 = textureLod(gInDepthHierarchy, ((vec2((_418 < 1.0) ? parameters.gOutputSize.x : 0.0, max(parameters.gOutputSize.y - floor((2.0 * _418) * parameters.gOutputSize.y), 0.0)) + _425) + vec2(0.5)) * _139, 0.0);
        float _453 = _452.x;
        vec3 _461 = (vec3((((((_425 * _419) + mix(vec2((_419 - 1.0) - _427), vec2(_427), fract(_425.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gOutputSize.zw) * parameters.gViewRay.xy + parameters.gViewRay.zw) * _453, _453) - _183) * _321;
        float _462 = dot(_461, _461);
        float _463 = 1.0 - _462;
        float _488 = 0.666666686534881591796875 + _305;
        vec2 _490 = (_317 * _488) * vec2(_403 * _301 + (-(_405 * _302)), _403 * _302 + (_405 * _301)) + _129;
        float _491 = _488 * _320;
        float _499 = (_491 < 16.0) ? 1.0 : ((_491 < 32.0) ? 0.5 : ((_491 < 64.0) ? 0.25 : ((_491 < 128.0) ? 0.125 : 0.0625)));
        float _500 = 1.0 / _499;
        vec2 _506 = min(floor(_490 * _499), floor(parameters.gOutputSize.xy * _499) - vec2(1.0));
        float _508 = floor(0.25 / _499);
        vec4 _533 = textureLod(gInDepthHierarchy, ((vec2((_499 < 1.0) ? parameters.gOutputSize.x : 0.0, max(parameters.gOutputSize.y - floor((2.0 * _499) * parameters.gOutputSize.y), 0.0)) + _506) + vec2(0.5)) * _139, 0.0);
        float _534 = _533.x;
        vec3 _542 = (vec3((((((_506 * _500) + mix(vec2((_500 - 1.0) - _508), vec2(_508), fract(_506.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gOutputSize.zw) * parameters.gViewRay.xy + parameters.gViewRay.zw) * _534, _534) - _183) * _321;
        float _543 = dot(_542, _542);
        float _544 = 1.0 - _543;
        vec2 _562 = (mix(vec2(0.0), vec2((_381 < 1.0) ? ((((_382 * _382) * _382) * max(_386 * _321 + dot(_380, _270), 0.0)) / (_381 + 0.00999999977648258209228515625)) : 0.0, 1.0), bvec2(all(lessThanEqual(abs(_328 * parameters.gOutputSize.zw + vec2(-0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2((_462 < 1.0) ? ((((_463 * _463) * _463) * max(_386 * _321 + dot(_461, _270), 0.0)) / (_462 + 0.00999999977648258209228515625)) : 0.0, 1.0), bvec2(all(lessThanEqual(abs(_409 * parameters.gOutputSize.zw + vec2(-0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2((_543 < 1.0) ? ((((_544 * _544) * _544) * max(_386 * _321 + dot(_542, _270), 0.0)) / (_543 + 0.00999999977648258209228515625)) : 0.0, 1.0), bvec2(all(lessThanEqual(abs(_490 * parameters.gOutputSize.zw + vec2(-0.5)), vec2(0.5)))));
        float _571 = 1.0 - (((5.0 * parameters.gIntensity) * _562.x) / max(_562.y, 1.0));
        float _576 = (_154 < 65504.0) ? ((_571 > 0.0) ? min(_571, 1.0) : 0.0) : 1.0;
        float _591 = min(dot(parameters.gViewToPreviousDepth, vec4(_181, _180.y, _154, 1.0)), parameters.gFarDepth);
        vec2 _593 = _129 * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, _131, 0.0).xy * parameters.gMotionToUv));
        vec2 _598 = mix(vec2(-8.0), _593, bvec2(all(lessThanEqual(abs(_593), vec2(8.0)))));
        float _601 = (abs(_591) <= 9.9999996802856924650656260769173e+37) ? _591 : 0.0;
        vec4 _605 = textureLod(gHistoryObscurance, _598, 0.0);
        float _606 = _605.x;
        float _610 = _605.w;
        vec4 _617 = floor((vec4((_606 > 0.0) ? min(_606, 1.0) : 0.0, (_610 > 0.0) ? min(_610, 1.0) : 0.0, _114, _114) * 255.0) + vec4(0.5));
        float _618 = _617.y;
        float _620 = floor(_618 * 0.0625);
        float _625 = ((16.0 * (_617.x - _620) + _618) - 8.0) * 0.00024509805371053516864776611328125;
        float _628 = (_625 > 0.0) ? min(_625, 1.0) : 0.0;
        float _629 = _605.y;
        float _630 = _605.z;
        vec4 _640 = floor((vec4((_629 > 0.0) ? min(_629, 1.0) : 0.0, (_630 > 0.0) ? min(_630, 1.0) : 0.0, _113, _113) * 255.0) + vec4(0.5));
        float _645 = min((_640.x * 256.0 + _640.y) * 1.525902189314365386962890625e-05, 1.0);
        float _649 = max(parameters.gFarDepth, 1.0000000133514319600180897396058e-10);
        float _655 = max(parameters.gMissThreshold.y * _601 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
        float _660 = _655 - abs((-((_645 > 0.0) ? min(_645, 1.0) : 0.0)) * _649 + _601);
        float _663 = (_660 > 0.0) ? (_660 * (2.0 / _655)) : 0.0;
        float _674 = (((_663 > 0.0) && all(lessThanEqual(abs(_598 - vec2(0.5)), vec2(0.5)))) ? min(_663, 1.0) : 0.0) * parameters.gHistoryValid;
        float _677 = (_674 * _674) * ((-2.0) * _674 + 3.0);
        float _678 = _620 * _677;
        float _683 = (_678 > 0.0) ? min(_678, 255.0) : 0.0;
        float _689 = min(_683 / (_683 + 1.0), (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0);
        float _692 = (_689 > 0.0) ? min(_689, 1.0) : 0.0;
        float _698 = (abs(_628) <= 9.9999996802856924650656260769173e+37) ? (_628 * _692 + (_576 * (1.0 - _692))) : _576;
        float _706 = min(((_620 > 0.0) ? min(_620, 255.0) : 0.0) * ((_677 > 0.0) ? min(_677, 1.0) : 0.0) + 1.0, 255.0);
        float _711 = fract(159.0 * fract(parameters.gFrameIndex * 0.00390625) + _291) + 0.001953125;
        float _720 = floor(((_698 > 0.0) ? min(_698, 1.0) : 0.0) * 4080.0 + ((_711 > 0.00200000009499490261077880859375) ? min(_711, 0.99800002574920654296875) : 0.00200000009499490261077880859375)) + 8.0;
        float _722 = floor(_720 * 0.0625);
        float _733 = min(((_154 > 0.0) ? min(_154, _649) : 0.0) / _649, 1.0);
        float _738 = floor(((_733 > 0.0) ? min(_733, 1.0) : 0.0) * 65535.0 + 0.5);
        float _740 = floor(_738 * 0.00390625);
        vec4 _746 = vec4(_722, 16.0 * floor(((_706 > 0.0) ? min(_706, 15.0) : 0.0) + 0.5) + ((-16.0) * _722 + _720), 0.0, 0.0) * vec4(0.0039215688593685626983642578125);
        imageStore(gOutObscurance, ivec2(gl_GlobalInvocationID.xy), vec4(_746.x, (vec4(_740, (-256.0) * _740 + _738, 0.0, 0.0) * vec4(0.0039215688593685626983642578125)).xy, _746.y));
        break;
    } while(false);
}

