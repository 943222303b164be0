using System.Numerics;
using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>A scene whose file has been read (<see cref="SceneLoader.Read"/>), and is not built yet.</summary>
public sealed class ReadScene
{
    private readonly SceneReadResult _read;
    private readonly string _folder;
    private readonly ModelFolder _models;
    private readonly int? _frame;

    private readonly SceneBudget _budget;

    internal ReadScene(SceneReadResult read, string folder, ModelFolder models, int? frame, SceneBudget budget) =>
        (_read, _folder, _models, _frame, _budget) = (read, folder, models, frame, budget);

    /// <summary>The description; null where the file has errors.</summary>
    public SceneDescription? Description => _read.Description is { } scene ? Shown(scene) : null;

    /// <summary>Builds the scene.</summary>
    /// <param name="overrides">As for <see cref="SceneLoader.Load"/>.</param>
    /// <param name="readPicture">As for <see cref="SceneLoader.Load"/>.</param>
    public SceneLoadResult Build(Func<SceneDescription, SceneDescription>? overrides = null, Func<string, bool, Picture>? readPicture = null)
    {
        Func<SceneDescription, SceneDescription>? changes = _frame is null ? overrides : scene => Shown(overrides?.Invoke(scene) ?? scene);
        using IDisposable counted = _budget.Begin();
        return SceneLoader.Build(_read, _folder, _models, changes, readPicture, keepsSources: false);
    }

    private SceneDescription Shown(SceneDescription scene) => _frame is { } frame ? AtFrame(scene, frame) : scene;

    // What moves does so by the time of the frame: the shutter opens then.
    internal static SceneDescription AtFrame(SceneDescription scene, int number) => scene with
    {
        Render = scene.Render with { Shutter = scene.Render.Shutter + new Vector2(number / scene.Render.FramesPerSecond) },
    };
}
