using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Loads scene files for the verbs.</summary>
internal static class SceneFile
{
    /// <summary>Loads a scene without a word.</summary>
    /// <param name="path">The scene file.</param>
    /// <param name="overrides">Changes the description before the scene is built; may be null.</param>
    /// <param name="readPicture">Reads pictures; null for <see cref="ImageFile.Read"/>.</param>
    /// <param name="settings">Values to put in the place of the file's; may be null.</param>
    /// <param name="frame">The frame of the animation; null for the scene as it is written.</param>
    public static SceneLoadResult Load(
        string path, Func<SceneDescription, SceneDescription>? overrides = null, Func<string, bool, Picture>? readPicture = null, IReadOnlyList<SceneSetting>? settings = null,
        int? frame = null) =>
        SceneLoader.Load(path, overrides, readPicture, settings, frame);

    /// <summary>Loads a scene without a word, but of how long it takes.</summary>
    /// <param name="path">The scene file.</param>
    /// <param name="stages">Told when the file has been read, and when the scene has been built.</param>
    /// <param name="readPicture">Reads pictures; null for <see cref="ImageFile.Read"/>.</param>
    /// <param name="settings">Values to put in the place of the file's; may be null.</param>
    public static SceneLoadResult Load(string path, StageTimes stages, Func<string, bool, Picture>? readPicture = null, IReadOnlyList<SceneSetting>? settings = null)
    {
        bool isRead = false;
        SceneLoadResult result = Load(path, scene =>
        {
            isRead = true;
            stages.EndLoad();
            return scene;
        }, readPicture, settings);
        if (isRead)
        {
            stages.EndBuild();
        }
        else
        {
            stages.EndLoad();
        }

        return result;
    }

    /// <summary>Loads a scene and shows what is wrong with it.</summary>
    /// <param name="path">The scene file.</param>
    /// <param name="streams">Where the diagnostics go.</param>
    /// <param name="overrides">Changes the description before the scene is built; may be null.</param>
    /// <param name="settings">Values to put in the place of the file's; may be null.</param>
    /// <param name="frame">The frame of the animation; null for the scene as it is written.</param>
    /// <param name="readPicture">Reads pictures; null for <see cref="ImageFile.Read"/>.</param>
    /// <param name="describe">Takes the description that the scene was built from; may be null.</param>
    /// <returns>The scene; null where there are errors.</returns>
    public static Scene? Load(
        string path, Streams streams, Func<SceneDescription, SceneDescription>? overrides = null, IReadOnlyList<SceneSetting>? settings = null, int? frame = null, Func<string, bool, Picture>? readPicture = null,
        Action<SceneDescription>? describe = null)
    {
        SceneLoadResult result = Load(path, overrides, readPicture, settings, frame);
        Show(result, streams);
        if (result.Description is { } description)
        {
            describe?.Invoke(description);
        }

        return result.Scene;
    }

    /// <summary>Shows diagnostics as a compiler does.</summary>
    public static void Show(SceneLoadResult result, Streams streams) => streams.Read(result.Diagnostics);

    /// <summary>The exit status for a scene that could not be loaded.</summary>
    public static int FailureStatus(string path) => File.Exists(path) ? ExitStatus.Scene : ExitStatus.InputOutput;
}
