using System.Globalization;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Sampling;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;
using JsonValue = System.Text.Json.Nodes.JsonValue;

namespace RayTracer.Session;

/// <summary>The text of the scene that a picture was rendered from, with the options that were given put in.</summary>
internal static class OriginText
{
    private static readonly Dictionary<string, string> Keys = new(StringComparer.Ordinal)
    {
        ["--width"] = "width",
        ["--height"] = "height",
        ["--seed"] = "seed",
        ["--max-depth"] = "maxDepth",
        ["--max-diffuse-depth"] = "maxDiffuseDepth",
        ["--max-specular-depth"] = "maxSpecularDepth",
        ["--integrator"] = "integrator",
        ["--sampler"] = "sampler",
    };

    /// <summary>Whether the text is another one than the file's.</summary>
    public static bool IsChanged(PictureOrigin origin) => NeedsWriting(origin) || origin.Options.Any(o => Keys.ContainsKey(o.Key));

    /// <summary>The text.</summary>
    /// <exception cref="DocumentException">The scene cannot be read, or has no such values.</exception>
    public static string Of(PictureOrigin origin)
    {
        JsonText text = JsonText.Of(NeedsWriting(origin) ? Written(origin) : SceneTextFile.Read(origin.Scene).Text);
        foreach ((string option, string value) in origin.Options)
        {
            text = Keys.TryGetValue(option, out string? key) ? text.Set($"/render/{key}", Value(option, value)) : text;
        }

        return text.Text;
    }

    // Only the words of the options that stand in the text itself can be put into it, and leave its comments where they are.
    private static bool NeedsWriting(PictureOrigin origin) =>
        ModelFile.IsModel(origin.Scene) || SceneFormat.Of(origin.Scene) is not null || origin.Options.Any(o => o.Key is "--set" or "--frames");

    private static string Written(PictureOrigin origin)
    {
        try
        {
            SceneSetting[] settings = [.. origin.Options.Where(o => o.Key == "--set").Select(o => SceneSetting.Parse(o.Value))];
            string? frames = origin.Options.LastOrDefault(o => o.Key == "--frames").Value;
            int? frame = frames is null ? null : int.Parse(frames, NumberStyles.None, CultureInfo.InvariantCulture);
            SceneDescription scene = SceneLoader.Describe(origin.Scene, null, settings, frame)
                ?? throw new DocumentException($"{origin.Scene} has errors, or cannot have the values that the picture was rendered with");

            // The values of the frame are in their places.
            return SceneWriter.Write(frame is null ? scene : scene with { Animation = [] });
        }
        catch (FormatException e)
        {
            throw new DocumentException($"the options of the picture cannot be read: {e.Message.TrimEnd('.')}", e);
        }
    }

    private static Json Value(string option, string value) => option switch
    {
        "--integrator" => Word(Integrator.Known, option, value),
        "--sampler" => Word(SamplerKind.Known, option, value),
        _ => long.TryParse(value, CultureInfo.InvariantCulture, out long number) ? JsonValue.Create(number) : throw new DocumentException($"the picture's {option} {value} is not a number"),
    };

    private static JsonValue Word(NamedValues known, string option, string value) =>
        JsonValue.Create(NamedValues.NameOf(known.Find(value) ?? throw new DocumentException($"the picture's {option} {value} is unknown")));
}
