using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Loads scene files for the verbs.</summary>
internal static class SceneFile
{
    /// <summary>The name of standard input as a scene, in commands.</summary>
    public const string Input = "-";

    /// <summary>Returns how messages call a scene.</summary>
    public static string Name(string path) => path == Input ? "<stdin>" : path;

    /// <summary>Loads a scene without a word, but of how long it takes.</summary>
    /// <param name="path">The scene file; <see cref="Input"/> for standard input.</param>
    /// <param name="stages">Takes the ends of reading the file, and of building the scene.</param>
    /// <param name="readPicture">Reads pictures; null for <see cref="ImageFile.Read"/>.</param>
    /// <param name="settings">Values to put in the place of the file's; may be null.</param>
    /// <param name="change">Changes the description before the scene is built; may be null.</param>
    public static SceneLoadResult Load(
        string path, StageTimes stages, Func<string, bool, Picture>? readPicture = null, IReadOnlyList<SceneSetting>? settings = null,
        Func<SceneDescription, SceneDescription>? change = null)
    {
        JobStage stage = JobStage.Load;
        ReadScene read = path == Input ? SceneLoader.ReadText(Console.In.ReadToEnd(), Name(path), "", settings) : SceneLoader.Read(path, settings);
        SceneLoadResult result = read.Build(
            scene =>
            {
                stages.End(JobStage.Load);
                stage = JobStage.Build;
                return change?.Invoke(scene) ?? scene;
            },
            readPicture);
        stages.End(stage);
        return result;
    }

    /// <summary>Returns the exit status for a scene that could not be loaded.</summary>
    public static int FailureStatus(string path) => path == Input || File.Exists(path) ? ExitStatus.Scene : ExitStatus.InputOutput;
}
