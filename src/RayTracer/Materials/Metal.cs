using System.Globalization;
using RayTracer.Numerics;
using RayTracer.Spectra;

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
/// colour matching functions of the CIE standard observer of 2° under light of equal energy, and n and k, each for itself, turned to Rec.
/// 709 primaries.
/// </summary>
internal static class MetalTable
{
    // The metal, then red, green and blue of n and of k.
    private static readonly Dictionary<Metal, float[]> s_numbers = EmbeddedTable.Read(typeof(MetalTable), "metals.txt")
        .ToDictionary(row => Enum.Parse<Metal>(row[0]), row => Array.ConvertAll(row[1..], n => float.Parse(n, CultureInfo.InvariantCulture)));

    /// <summary>The index of a metal.</summary>
    public static (Rgb Eta, Rgb K) Of(Metal metal) => s_numbers.TryGetValue(metal, out float[]? n) ? (new(n[0], n[1], n[2]), new(n[3], n[4], n[5]))
        : throw new ArgumentOutOfRangeException(nameof(metal), metal, "No metal has this name.");
}
