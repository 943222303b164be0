using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Media;

/// <summary>
/// The priority of a dielectric's inside among others that overlap it (Schmidt &amp; Budge, Simple nested dielectrics in ray traced images,
/// 2002).
/// </summary>
/// <param name="Priority">Where several overlap, the one with the highest priority is there; above 0.</param>
/// <param name="Index">Refractive index, relative to empty space.</param>
/// <param name="Extinction">Extinction coefficient of what only absorbs, per scene unit.</param>
public sealed record Nesting(int Priority, Dispersion Index, Rgb Extinction);
