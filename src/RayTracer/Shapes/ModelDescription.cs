using RayTracer.Description;

namespace RayTracer.Shapes;

/// <summary>Describes all shapes and lights of a model file, made of the file's own materials.</summary>
[SceneType("model", "Everything in a model file, with its own materials and lights. A material given here replaces all of them.")]
public sealed record ModelDescription : ShapeDescription
{
    /// <summary>The model's file.</summary>
    [Parameter("The model's file.", IsFile = true, Required = true)]
    public string File { get; init; } = "";

    /// <summary>The way in which an animation in the file is played.</summary>
    [Parameter("How an animation in the file is played; without it, the file's first one from the scene's time 0.")]
    public PlaybackDescription Playback { get; init; } = new();

    /// <summary>The look of its materials, by its name in the file; empty for the file's own.</summary>
    [Parameter("Which look its materials have, by the name of a variant in the file. Without it, the look that the file gives them first.")]
    public string Variant { get; init; } = "";

    /// <summary>True where meshes without normals are shaded smoothly.</summary>
    [Parameter("Whether meshes without normals of their own are shaded smoothly: by the mean of the triangles around each corner, weighted by their angles there, up to the crease angle.")]
    public bool Smooth { get; init; }

    /// <summary>What makes its meshes fine and round.</summary>
    [Parameter("What makes its meshes fine and round: subdivision, creases, displacement.")]
    public RefinementDescription Refinement { get; init; } = new();

    /// <inheritdoc/>
    public override SketchKinds SketchedAs => SketchKinds.Shape;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { File = view.File ?? "" };

    /// <summary>Returns null: it is no single shape.</summary>
    public override Shape? Build(SceneBuilder builder) => null;
}

/// <summary>The way in which an animation in a model file is played.</summary>
public sealed record PlaybackDescription
{
    /// <summary>The animation's name; empty for the first one.</summary>
    [Parameter("Which animation, by its name in the file. Without it, the first.")]
    public string Animation { get; init; } = "";

    /// <summary>The time in the animation when the scene's is 0.</summary>
    [Parameter("The time in the animation when the scene's is 0.", Unit = "seconds")]
    public float Start { get; init; }

    /// <summary>Seconds of the animation in one of the scene.</summary>
    [Parameter("How fast it is played: 2 is twice as fast, -1 backwards, and 0 holds it at its start.")]
    public float Speed { get; init; } = 1;

    /// <summary>True where it begins again when it is over.</summary>
    [Parameter("Whether it begins again when it is over. Otherwise everything stays where it is then.")]
    public bool Repeat { get; init; }

    /// <summary>The time in an animation at a time of the scene.</summary>
    /// <param name="time">The time of the scene, in seconds.</param>
    /// <param name="length">How long the animation takes, in seconds.</param>
    internal double TimeAt(double time, double length)
    {
        double played = Start + (Speed * time);
        return Repeat && length > 0 ? played - (length * double.Floor(played / length)) : double.Clamp(played, 0, length);
    }
}
