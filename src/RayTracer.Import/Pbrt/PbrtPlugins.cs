namespace RayTracer.Import;

/// <summary>What pbrt has and this reader refuses, by kind and type, with the reason.</summary>
internal static class PbrtPlugins
{
    /// <summary>The reasons.</summary>
    public static IReadOnlyDictionary<(string Kind, string Type), string> Refused { get; } = """
        material hair: light within fibres is not simulated
        material measured: measured tables are not read
        material subsurface: "dielectric" with a medium inside is
        texture ptex: files of Ptex are not read
        texture directionmix: nothing here depends on a direction
        camera realistic: lenses of several glasses are not simulated
        integrator mlt: "bdpt" is as good with caustics
        integrator function: it renders no scene
        film spectral: pictures have red, green and blue
        filter sinc: "mitchell" is as sharp
        """.Split(['\n', '\r'], StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split([' ', ':'], 3))
        .ToDictionary(words => (words[0], words[1]), words => words[2].Trim());

    /// <summary>The things of a kind, in messages.</summary>
    public static string PluralOf(string kind) => kind == "medium" ? "media" : kind + "s";

    /// <summary>What stands in for a thing of a kind, as the end of a sentence.</summary>
    public static string StandInOf(string kind) => kind switch
    {
        "material" or "texture" => "magenta is shown instead",
        "shape" => "a magenta ball is shown instead",
        "light" or "area light" or "medium" => "it is left out",
        _ => "the default is used instead",
    };
}
