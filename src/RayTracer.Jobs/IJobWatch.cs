using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>The stages of a job.</summary>
public enum JobStage
{
    /// <summary>The scene's file is read.</summary>
    Load,

    /// <summary>Pictures and models are read, and what rays meet is built.</summary>
    Build,

    /// <summary>The picture is rendered.</summary>
    Render,

    /// <summary>The noise is taken out of the picture.</summary>
    Denoise,

    /// <summary>Files are written.</summary>
    Write,
}

/// <summary>Takes what a job reports, and shows how far it is.</summary>
public interface IJobWatch
{
    /// <summary>True if it shows the film between passes, so that there must be passes.</summary>
    bool ShowsPasses => false;

    /// <summary>Takes a line about something doubtful.</summary>
    void Warn(string message);

    /// <summary>Takes a line about something that went wrong without ending the job.</summary>
    void Fail(string message);

    /// <summary>Takes what there is to say about the scene.</summary>
    void Read(IReadOnlyList<Diagnostic> diagnostics);

    /// <summary>Takes the settings of a scene that was read, with as many samples as pixels may come to, before it is built.</summary>
    void Begin(SceneDescription scene)
    {
    }

    /// <summary>Takes the end of a stage.</summary>
    void End(JobStage stage)
    {
    }

    /// <summary>Returns an image that is about to be written, through which the writer is followed.</summary>
    IImageRows Rows(IImageRows image) => image;

    /// <summary>Begins to show how far the rendering or the denoising is, until that is disposed of; null where nothing is shown.</summary>
    IProgress<RenderProgress>? Begin(RenderDescription render) => null;

    /// <summary>Takes the film as it is after a pass.</summary>
    /// <param name="film">The film.</param>
    /// <param name="isLast">True if no other pass follows.</param>
    void Offer(Film film, bool isLast)
    {
    }
}
