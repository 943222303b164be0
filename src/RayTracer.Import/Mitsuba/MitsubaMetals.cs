using System.Globalization;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes metals.</summary>
internal sealed class MitsubaMetals(MitsubaTextures textures)
{
    private const string Palik = "_palik";

    // Those whose table bears Palik's name too.
    private static readonly string[] s_palik =
        "AlAs AlSb Be CsI Cu2O CuO Hg HgTe Ir K Li MgO Mo Nb Rh Se Se-e SiC SnTe Ta Te Te-e ThF4 TiC TiN TiO2 TiO2-e VC VN d-C".Split(' ');

    private static readonly Dictionary<string, Metal> s_names = """
        none None, Ag Silver, Al Aluminium, Au Gold, Be Beryllium, Cr Chromium, Cu Copper, Hg Mercury, Ir Iridium,
        K Potassium, Li Lithium, Mo Molybdenum, Na_palik Sodium, Nb Niobium, Ni_palik Nickel, Rh Rhodium, Ta Tantalum,
        TiN TitaniumNitride, V_palik Vanadium, W Tungsten
        """.Split([',', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
        .Select(entry => entry.Split(' ')).ToDictionary(words => words[0], words => Enum.Parse<Metal>(words[1]));

    // Those that are no metal of ours: the real and the imaginary parts for red, green and blue, as Mitsuba has them when it renders in RGB.
    private static readonly Dictionary<string, (Rgb Eta, Rgb K)> s_others = """
        AlAs 3.6053 3.23294 2.21632 0.000679437 0 0.00751271
        AlSb 0.001 4.13937 4.66925 0 0.0940091 1.30057
        CsI 2.1449 1.70232 1.66243 0 0 0
        Cu2O 3.55177 2.94987 2.75188 0.114207 0.193897 0.606134
        CuO 3.24754 2.44781 2.21022 0.52109 0.570031 0.722179
        Cu_palik 0.213229 0.919715 1.10241 3.92187 2.45733 2.13658
        HgTe 4.77904 3.2312 2.6599 1.63161 1.58081 1.72929
        MgO 2.08958 1.65072 1.59488 0 0 0
        Se 4.05831 2.84294 2.82085 0.75405 0.638444 0.521808
        Se-e 5.72285 4.16574 4.08134 0.871136 1.10516 1.56532
        SiC 3.17234 2.52597 2.47937 0 0 0.0000101925
        SnTe 4.52425 1.98164 1.28159 0 0 0
        Te 7.39023 4.4821 2.63711 3.25602 3.52706 3.29205
        Te-e 7.50891 4.29643 2.36999 5.58393 4.94721 3.99759
        ThF4 1.83071 1.44223 1.38765 0 0 0
        TiC 3.70053 2.83742 2.58229 3.26564 2.35159 2.17279
        TiO2 3.45661 2.80174 2.90517 0.000105265 0 0.000652887
        TiO2-e 3.10656 2.51317 2.58244 0.0000297516 0 0.000182698
        VC 3.65757 2.75274 2.53267 3.0683 2.19869 1.96319
        VN 2.8656 2.11919 1.94009 3.03224 2.05612 1.61631
        a-C 2.94405 2.22714 1.96816 0.887465 0.799299 0.81529
        d-C 2.70872 2.31883 2.2289 0 0 0
        """.Split(['\n', '\r'], StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split(' '))
        .ToDictionary(words => words[0], words => (Channels(words.AsSpan(1, 3)), Channels(words.AsSpan(4, 3))));

    private static readonly string[] s_known = [.. s_names.Keys, .. s_others.Keys, .. s_palik.Select(n => n + Palik)];

    /// <summary>A smooth or rough metal.</summary>
    public MaterialDescription Read(MitsubaObject bsdf)
    {
        (Metal? name, Rgb? eta, Rgb? k) = Index(bsdf);
        TextureDescription factor = textures.Read(bsdf, "specular_reflectance", Rgb.White);
        if (bsdf.Type == "conductor")
        {
            return new ConductorMaterialDescription { Metal = name, Eta = eta, K = k, SpecularReflectance = factor };
        }

        MitsubaRoughness rough = MitsubaRoughness.Read(bsdf, textures);
        return new RoughConductorMaterialDescription
        {
            Metal = name,
            Eta = eta,
            K = k,
            SpecularReflectance = factor,
            Distribution = rough.Distribution,
            Alpha = rough.Alpha,
            AlphaU = rough.AlphaU,
            AlphaV = rough.AlphaV,
        };
    }

    private static (Metal? Name, Rgb? Eta, Rgb? K) Named(MitsubaObject bsdf)
    {
        string name = bsdf.Choice("material", "none", s_known.ToDictionary(n => n));
        name = name.EndsWith(Palik, StringComparison.Ordinal) && s_palik.Contains(name[..^Palik.Length]) ? name[..^Palik.Length] : name;
        return s_names.TryGetValue(name, out Metal metal) ? (metal, null, null) : (null, s_others[name].Eta, s_others[name].K);
    }

    private static Rgb Channels(ReadOnlySpan<string> words) => new(Number(words[0]), Number(words[1]), Number(words[2]));

    private static float Number(string word) => float.Parse(word, CultureInfo.InvariantCulture);

    private static (Metal? Name, Rgb? Eta, Rgb? K) Index(MitsubaObject bsdf)
    {
        bsdf.Ignore("eta", "k", "material");
        if (bsdf.Has("material") && bsdf.Has("eta"))
        {
            bsdf.Log.Error(bsdf.PlaceOf("eta"), "either \"material\" or \"eta\" and \"k\" may be given, but not both");
        }

        if (bsdf.Has("material"))
        {
            return Named(bsdf);
        }

        bool hasEta = bsdf.Has("eta") || bsdf.HasChild("eta");
        bool hasK = bsdf.Has("k") || bsdf.HasChild("k");
        if (hasEta != hasK)
        {
            bsdf.Log.Error(bsdf.Place, $"{bsdf.Describe()} needs both \"eta\" and \"k\", or neither");
        }

        return hasEta && hasK ? (null, MitsubaColors.Read(bsdf, "eta", Rgb.White), MitsubaColors.Read(bsdf, "k", Rgb.Black)) : (Metal.None, null, null);
    }
}
