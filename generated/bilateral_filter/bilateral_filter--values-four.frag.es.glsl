#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

uniform highp sampler2D gInCacheState;
uniform highp sampler2D gInCache;
uniform highp sampler2D gInCacheFiltered;
uniform highp sampler2D gInCacheStateFiltered;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _65 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _68 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _72 = textureLod(gInCacheState, _65, 0.0);
    vec4 _76 = textureLod(gInCache, _65, 0.0);
    float _77 = _72.y;
    vec2 _79 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * (-3.5));
    vec4 _83 = textureLod(gInCacheFiltered, _79, 0.0);
    vec2 _90 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * (-1.5));
    vec4 _92 = textureLod(gInCacheFiltered, _90, 0.0);
    vec2 _97 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * 1.5);
    vec4 _99 = textureLod(gInCacheFiltered, _97, 0.0);
    vec2 _104 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * 3.5);
    vec4 _106 = textureLod(gInCacheFiltered, _104, 0.0);
    float _116 = _72.x / max(parameters.gConverged, 1.0);
    float _129 = (((((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_116 > 0.0) ? min(_116, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
    float _132 = (_129 > 0.0) ? min(_129, 16.0) : 0.0;
    float _141 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_77 > 0.001000000047497451305389404296875) ? min(_77, 65504.0) : 0.001000000047497451305389404296875));
    float _143 = abs(textureLod(gInCacheStateFiltered, _79, 0.0).y - _77);
    float _147 = (_141 > 0.0) ? min(_141, 9.9999996169031624536541560020822e+35) : 0.0;
    float _152 = 0.0544886849820613861083984375 * (_132 * ((_143 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_147 * _143 + 1.0)) : 0.0));
    bool _155 = all(lessThanEqual(abs(_83), vec4(65504.0)));
    vec4 _156 = _83 * _152;
    bvec4 _157 = bvec4(_155);
    float _161 = abs(textureLod(gInCacheStateFiltered, _90, 0.0).y - _77);
    float _167 = 0.24420134723186492919921875 * (_132 * ((_161 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_147 * _161 + 1.0)) : 0.0));
    bool _170 = all(lessThanEqual(abs(_92), vec4(65504.0)));
    vec4 _171 = _92 * _167;
    bvec4 _172 = bvec4(_170);
    bool _179 = all(lessThanEqual(abs(_76), vec4(65504.0)));
    vec4 _180 = _76 * 0.40261995792388916015625;
    bvec4 _181 = bvec4(_179);
    float _187 = abs(textureLod(gInCacheStateFiltered, _97, 0.0).y - _77);
    float _193 = 0.24420134723186492919921875 * (_132 * ((_187 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_147 * _187 + 1.0)) : 0.0));
    bool _196 = all(lessThanEqual(abs(_99), vec4(65504.0)));
    vec4 _197 = _99 * _193;
    bvec4 _198 = bvec4(_196);
    float _204 = abs(textureLod(gInCacheStateFiltered, _104, 0.0).y - _77);
    float _210 = 0.0544886849820613861083984375 * (_132 * ((_204 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_147 * _204 + 1.0)) : 0.0));
    bool _213 = all(lessThanEqual(abs(_106), vec4(65504.0)));
    vec4 _214 = _106 * _210;
    bvec4 _215 = bvec4(_213);
    float _219 = ((((_155 ? _152 : 0.0) + (_170 ? _167 : 0.0)) + (_179 ? 0.40261995792388916015625 : 0.0)) + (_196 ? _193 : 0.0)) + (_213 ? _210 : 0.0);
    vec4 _222 = ((((vec4(_157.x ? _156.x : vec4(0.0).x, _157.y ? _156.y : vec4(0.0).y, _157.z ? _156.z : vec4(0.0).z, _157.w ? _156.w : vec4(0.0).w) + vec4(_172.x ? _171.x : vec4(0.0).x, _172.y ? _171.y : vec4(0.0).y, _172.z ? _171.z : vec4(0.0).z, _172.w ? _171.w : vec4(0.0).w)) + vec4(_181.x ? _180.x : vec4(0.0).x, _181.y ? _180.y : vec4(0.0).y, _181.z ? _180.z : vec4(0.0).z, _181.w ? _180.w : vec4(0.0).w)) + vec4(_198.x ? _197.x : vec4(0.0).x, _198.y ? _197.y : vec4(0.0).y, _198.z ? _197.z : vec4(0.0).z, _198.w ? _197.w : vec4(0.0).w)) + vec4(_215.x ? _214.x : vec4(0.0).x, _215.y ? _214.y : vec4(0.0).y, _215.z ? _214.z : vec4(0.0).z, _215.w ? _214.w : vec4(0.0).w)) * (1.0 / _219);
    bvec4 _223 = bvec4(_219 > 1.0000000031710768509710513471353e-30);
    gOutFiltered = vec4(_223.x ? _222.x : vec4(0.0).x, _223.y ? _222.y : vec4(0.0).y, _223.z ? _222.z : vec4(0.0).z, _223.w ? _222.w : vec4(0.0).w);
}

