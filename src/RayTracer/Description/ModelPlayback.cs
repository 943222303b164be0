using RayTracer.Shapes;

namespace RayTracer.Description;

/// <summary>Plays the animations of models.</summary>
internal static class ModelPlayback
{
    /// <summary>A model as it is while the shutter is open; null where it has no animation, or not the one that is named, which is reported.</summary>
    /// <param name="model">Its place in the scene.</param>
    /// <param name="imported">The content of its file.</param>
    /// <param name="builder">Has the shutter, and takes the diagnostics.</param>
    public static SceneDescription? Of(ModelDescription model, ImportedModel imported, SceneBuilder builder)
    {
        PlaybackDescription playback = model.Playback;
        List<string> names = [.. imported.Animations.Select(a => a.Name)];
        int played = playback.Animation.Length == 0 ? 0 : names.IndexOf(playback.Animation);
        if (played < 0)
        {
            string known = names.Count == 0 ? "it has none" : $"it has {string.Join(", ", names.Take(10).Select(Quotation.Of))}";
            builder.Error(playback, nameof(PlaybackDescription.Animation),
                $"there is no animation {Quotation.Of(playback.Animation)} in \"{model.File}\": {known}{Spelling.DidYouMean(playback.Animation, names)}");
            return null;
        }

        if (imported.At is not { } at)
        {
            return null;
        }

        double seconds = imported.Animations[played].Seconds;
        builder.Played[(model.File, playback.Animation)] = seconds;
        try
        {
            return at(new(played, builder.Shutter.Open, builder.Shutter.Close, time => playback.TimeAt(time, seconds)));
        }
        catch (ModelException e)
        {
            builder.Error(model, nameof(ModelDescription.File), $"cannot play \"{model.File}\": {e.Message}");
            return null;
        }
    }
}
