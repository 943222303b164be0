using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>Metals, and a mirror without loss.</summary>
public enum Metal
{
    /// <summary>No metal: everything is reflected.</summary>
    None,

    /// <summary>Al.</summary>
    Aluminium,

    /// <summary>Be.</summary>
    Beryllium,

    /// <summary>Cr.</summary>
    Chromium,

    /// <summary>Cu.</summary>
    Copper,

    /// <summary>Au.</summary>
    Gold,

    /// <summary>Ir.</summary>
    Iridium,

    /// <summary>Fe.</summary>
    Iron,

    /// <summary>Li.</summary>
    Lithium,

    /// <summary>Hg.</summary>
    Mercury,

    /// <summary>Mo.</summary>
    Molybdenum,

    /// <summary>Ni.</summary>
    Nickel,

    /// <summary>Nb.</summary>
    Niobium,

    /// <summary>Pt.</summary>
    Platinum,

    /// <summary>K.</summary>
    Potassium,

    /// <summary>Rh.</summary>
    Rhodium,

    /// <summary>Ag.</summary>
    Silver,

    /// <summary>Na.</summary>
    Sodium,

    /// <summary>Ta.</summary>
    Tantalum,

    /// <summary>Ti.</summary>
    Titanium,

    /// <summary>TiN, as gold as gold on tools.</summary>
    TitaniumNitride,

    /// <summary>W.</summary>
    Tungsten,

    /// <summary>V.</summary>
    Vanadium,
}

/// <summary>
/// Complex refractive indices n + ik of metals against air. The wavelengths of published tables (Palik, Handbook of Optical Constants of Solids,
/// 1985; for iron and titanium Johnson &amp; Christy, Optical constants of transition metals, 1974; for platinum Werner, Glantschnig &amp;
/// Ambrosch-Draxl, Optical constants and inelastic electron-scattering data for 17 elemental metals, 2009) are weighted with the
/// colour matching functions of the CIE standard observer of 2° under light of equal energy, and n and k, each for itself, turned to Rec. 709 primaries.
/// </summary>
internal static class MetalTable
{
    /// <summary>The index of a metal.</summary>
    public static (Rgb Eta, Rgb K) Of(Metal metal) => metal switch
    {
        Metal.Aluminium => (new(1.6575f, 0.880405f, 0.521244f), new(9.22381f, 6.2695f, 4.837f)),
        Metal.Beryllium => (new(4.18501f, 3.18503f, 2.78406f), new(3.83547f, 3.01012f, 2.86899f)),
        Metal.Chromium => (new(4.36967f, 2.91651f, 1.6549f), new(5.20655f, 4.23131f, 3.7547f)),
        Metal.Copper => (new(0.201005f, 0.92375f, 1.10222f), new(3.91326f, 2.45305f, 2.14209f)),
        Metal.Gold => (new(0.143036f, 0.375307f, 1.44205f), new(3.983f, 2.38556f, 1.60336f)),
        Metal.Iridium => (new(3.0863f, 2.08219f, 1.61791f), new(5.59215f, 4.06709f, 3.26731f)),
        Metal.Iron => (new(3.51448f, 2.76977f, 2.30174f), new(3.69503f, 2.78613f, 2.49299f)),
        Metal.Lithium => (new(0.265791f, 0.195618f, 0.220949f), new(3.54015f, 2.31112f, 1.66861f)),
        Metal.Mercury => (new(2.39894f, 1.44003f, 0.90957f), new(6.32759f, 4.37192f, 3.42176f)),
        Metal.Molybdenum => (new(4.48397f, 3.52513f, 2.77631f), new(4.11144f, 3.42083f, 3.15061f)),
        Metal.Nickel => (new(2.3673f, 1.66337f, 1.46708f), new(4.49881f, 3.05015f, 2.34544f)),
        Metal.Niobium => (new(3.42007f, 2.79009f, 2.39563f), new(3.44139f, 2.73767f, 2.57975f)),
        Metal.Platinum => (new(0.563428f, 0.437037f, 0.620314f), new(7.42578f, 4.7672f, 3.25385f)),
        Metal.Potassium => (new(0.0640432f, 0.0464098f, 0.0381849f), new(2.1042f, 1.34894f, 0.913126f)),
        Metal.Rhodium => (new(2.58579f, 1.86022f, 1.55426f), new(6.78226f, 4.70299f, 3.97607f)),
        Metal.Silver => (new(0.155276f, 0.116728f, 0.138388f), new(4.82835f, 3.12222f, 2.1469f)),
        Metal.Sodium => (new(0.0602694f, 0.0561409f, 0.0619884f), new(3.17927f, 2.11249f, 1.57904f)),
        Metal.Tantalum => (new(2.06272f, 2.39294f, 2.62793f), new(2.40836f, 1.74149f, 1.94703f)),
        Metal.Titanium => (new(3.27541f, 2.37976f, 2.0247f), new(4.57235f, 3.22453f, 2.72781f)),
        Metal.TitaniumNitride => (new(1.64845f, 1.15052f, 1.37982f), new(3.36833f, 1.9435f, 1.10207f)),
        Metal.Tungsten => (new(4.37082f, 3.30025f, 2.99841f), new(3.50064f, 2.60487f, 2.27323f)),
        Metal.Vanadium => (new(4.27758f, 3.51295f, 2.76107f), new(3.4913f, 2.88945f, 3.11152f)),
        _ => throw new ArgumentOutOfRangeException(nameof(metal), metal, "No metal has this name."),
    };
}
