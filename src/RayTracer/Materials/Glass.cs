using System.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Materials;

/// <summary>Clear things whose refractive indices are in published tables.</summary>
public enum Glass
{
    /// <summary>Fused quartz (fused silica).</summary>
    FusedQuartz,

    /// <summary>N-BK7, the most usual optical glass: a crown.</summary>
    Bk7,

    /// <summary>N-BAK4, a crown.</summary>
    Bak4,

    /// <summary>F2, a flint.</summary>
    F2,

    /// <summary>SF10, a dense flint.</summary>
    Sf10,

    /// <summary>SF11, a denser one.</summary>
    Sf11,

    /// <summary>Lead crystal's extreme: N-LASF9, a lanthanum flint.</summary>
    Lasf9,

    /// <summary>Diamond.</summary>
    Diamond,

    /// <summary>Sapphire, for its ordinary ray.</summary>
    Sapphire,

    /// <summary>Water at 20 °C.</summary>
    Water,
}

/// <summary>The refractive indices of glasses.</summary>
internal static class GlassTable
{
    /// <summary>
    /// How a glass's index depends on the wavelength: fused quartz by Malitson 1965, eq. 1; sapphire by Malitson 1962, table I; diamond by Peter 1923; water by
    /// Daimon and Masumura 2007, table 2; the others by their maker's data sheets (SCHOTT 2017).
    /// </summary>
    public static Dispersion Dispersion(this Glass glass) => glass switch
    {
        Glass.FusedQuartz => Three(0.6961663f, 0.4079426f, 0.8974794f, 0.0684043f * 0.0684043f, 0.1162414f * 0.1162414f, 9.896161f * 9.896161f),
        Glass.Bk7 => Three(1.03961212f, 0.231792344f, 1.01046945f, 0.00600069867f, 0.0200179144f, 103.560653f),
        Glass.Bak4 => Three(1.28834642f, 0.132817724f, 0.945395373f, 0.00779980626f, 0.0315631177f, 105.965875f),
        Glass.F2 => Three(1.34533359f, 0.209073176f, 0.937357162f, 0.00997743871f, 0.0470450767f, 111.886764f),
        Glass.Sf10 => Three(1.61625977f, 0.259229334f, 1.07762317f, 0.0127534559f, 0.0581983954f, 116.60768f),
        Glass.Sf11 => Three(1.73848403f, 0.311168974f, 1.17490871f, 0.0136068604f, 0.0615960463f, 121.922711f),
        Glass.Lasf9 => Three(2.00029547f, 0.298926886f, 1.80691843f, 0.0121426017f, 0.0538736236f, 156.530829f),
        Glass.Diamond => Three(0.3306f, 4.3356f, 0, 0.175f * 0.175f, 0.106f * 0.106f, 0),
        Glass.Sapphire => Three(1.4313493f, 0.65054713f, 5.3414021f, 0.0726631f * 0.0726631f, 0.1193242f * 0.1193242f, 18.028251f * 18.028251f),
        _ => Spectra.Dispersion.Sellmeier(new(0.5684027565f, 0.1726177391f, 0.02086189578f, 0.1130748688f), new(0.005101829712f, 0.01821153936f, 0.02620722293f, 10.69792721f)),
    };

    private static Dispersion Three(float b1, float b2, float b3, float c1, float c2, float c3) =>
        Spectra.Dispersion.Sellmeier(new(b1, b2, b3, 0), new(c1, c2, c3, 0));
}
