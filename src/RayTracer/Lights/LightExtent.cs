using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>A light as known from afar.</summary>
/// <param name="Box">A box around it while the shutter is open; infinite where it shines from infinitely far away.</param>
/// <param name="Strength">Its mean radiant intensity over all directions; or the irradiance that one infinitely far away brings. In
/// luminance.</param>
public readonly record struct LightExtent(Bounds Box, float Strength);
