using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>What the view shows, as a job.</summary>
internal static class ViewJob
{
    /// <summary>The job that renders a document as it was saved last.</summary>
    /// <param name="place">Where the document is at home.</param>
    /// <param name="scene">What it says.</param>
    /// <param name="settings">What the user wants besides.</param>
    /// <param name="tone">How light is brought into the picture.</param>
    /// <param name="output">The picture's file; null for one beside the scene's.</param>
    public static RenderJob Of(DocumentPlace place, SceneDescription? scene, ViewSettings settings, Tone tone, string? output = null)
    {
        string path = place.Path ?? place.Name;
        return new()
        {
            Scene = path,
            Outputs = [output ?? Path.ChangeExtension(path, ".png")],
            Settings = settings.Samples is { } samples && samples != scene?.Render.SamplesPerPixel ? [SceneSetting.Parse($"{RenderJob.SamplesPath}={samples}")] : [],
            Crop = settings.Region,
            Threads = settings.Threads,
            Writing = new() { Exposure = tone.Exposure, ToneMap = tone.ToneMap },
            Denoise = settings.Map == ViewMap.Denoised,
        };
    }
}
