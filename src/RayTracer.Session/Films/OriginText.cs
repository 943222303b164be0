using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;
using JsonValue = System.Text.Json.Nodes.JsonValue;

namespace RayTracer.Session;

/// <summary>
/// The text of the scene that a picture was rendered from, with its settings put in. The number of samples is the view's.
/// </summary>
internal static class OriginText
{
    private const string Render = "render.";

    /// <summary>Returns whether the text is another one than the file's.</summary>
    public static bool IsChanged(RenderJob origin) => NeedsWriting(origin) || Settings(origin).Any();

    /// <summary>The text.</summary>
    /// <exception cref="SessionException">The scene cannot be read, or has no such values.</exception>
    public static string Of(RenderJob origin) => NeedsWriting(origin) ? Written(origin)
        : Settings(origin).Aggregate(JsonText.Of(SceneTextFile.Read(origin.Scene).Text), (text, s) => text.Set($"/render/{s.Path[Render.Length..]}", Value(s.Value))).Text;

    private static IEnumerable<SceneSetting> Settings(RenderJob origin) => origin.Settings.Where(s => s.Path != RenderJob.SamplesPath);

    // Only plain values of the picture's own record can be put into the text itself, and leave its comments where they are.
    private static bool NeedsWriting(RenderJob origin) =>
        ModelFile.IsModel(origin.Scene) || SceneFormat.Of(origin.Scene) is not null || origin.Frame is not null
        || Settings(origin).Any(s => !(s.Path.StartsWith(Render, StringComparison.Ordinal) && s.Path[Render.Length..].All(char.IsLetter) && s.Value.All(c => char.IsLetterOrDigit(c) || c == '-')));

    private static string Written(RenderJob origin)
    {
        SceneDescription scene = (origin with { Settings = [.. Settings(origin)] }).Describe()
            ?? throw new SessionException($"{origin.Scene} has errors, or cannot have the values that the picture was rendered with");

        // The values of the frame are in their places.
        return SceneWriter.Write(origin.Frame is null ? scene : scene with { Animation = [] });
    }

    private static Json Value(string word) => long.TryParse(word, out long number) ? JsonValue.Create(number) : JsonValue.Create(word);
}
