using RayTracer.Shapes;

namespace RayTracer.Description;

/// <summary>Plays the animations of models, and chooses among their looks.</summary>
internal static class ModelPlayback
{
    /// <summary>A model as it is while the shutter is open.</summary>
    /// <param name="model">Its place in the scene. What it names and the file does not have is reported.</param>
    /// <param name="imported">The content of its file.</param>
    /// <param name="builder">Has the shutter, and takes the diagnostics.</param>
    public static SceneDescription Of(ModelDescription model, ImportedModel imported, SceneBuilder builder)
    {
        PlaybackDescription playback = model.Playback;
        int? animation = Number(playback.Animation, [.. imported.Animations.Select(a => a.Name)], "animation",
            complaint => builder.Error(playback, nameof(PlaybackDescription.Animation), complaint));
        int? variant = Number(model.Variant, imported.Variants, "variant", complaint => builder.Error(model, nameof(ModelDescription.Variant), complaint));
        if (imported.At is not { } at)
        {
            return imported.Scene;
        }

        double seconds = imported.Animations.Count == 0 ? 0 : imported.Animations[animation ?? 0].Seconds;
        if (imported.Animations.Count > 0)
        {
            builder.Played[(model.File, playback.Animation)] = seconds;
        }

        try
        {
            return at(new(animation ?? 0, variant, builder.Shutter.Open, builder.Shutter.Close, time => playback.TimeAt(time, seconds)));
        }
        catch (ModelException e)
        {
            builder.Error(model, nameof(ModelDescription.File), $"cannot play \"{model.File}\": {e.Message}");
            return imported.Scene;
        }
    }

    // Null where nothing is named.
    private static int? Number(string name, IReadOnlyList<string> names, string what, Action<string> report)
    {
        int number = names.ToList().IndexOf(name);
        if (name.Length > 0 && number < 0)
        {
            string known = names.Count == 0 ? "it has none" : $"it has {string.Join(", ", names.Take(10).Select(Quotation.Of))}";
            report($"there is no {what} {Quotation.Of(name)} in the file: {known}{Spelling.DidYouMean(name, names)}");
        }

        return name.Length > 0 && number >= 0 ? number : null;
    }
}
