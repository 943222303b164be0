using System.Numerics;

namespace RayTracer.Description;

/// <summary>The contents of a model file, in the terms of scenes.</summary>
/// <param name="Scene">Shapes (groups, meshes, instances) with their materials, and lights as shapes that shine.</param>
/// <param name="Notes">The things that could not be represented exactly, one sentence each without a final stop: shown as warnings, once a
/// file.</param>
public sealed record ImportedModel(SceneDescription Scene, IReadOnlyList<string> Notes)
{
    /// <summary>The file's first camera; null where there is none.</summary>
    public CameraDescription? Camera { get; init; }

    /// <summary>The direction that is up in files of its format.</summary>
    public Vector3 Up { get; init; } = Vector3.UnitY;

    /// <summary>The animations in the file; <see cref="Scene"/> is as at the beginning of the first.</summary>
    public IReadOnlyList<ModelAnimation> Animations { get; init; } = [];

    /// <summary>The names of the looks that its materials can have, besides that of <see cref="Scene"/>.</summary>
    public IReadOnlyList<string> Variants { get; init; } = [];

    /// <summary>
    /// The scene while the shutter is open: what moves has keyframes at times of the scene, and what bends is as in the middle. May throw
    /// <see cref="ModelException"/>. Null where there are neither animations nor variants.
    /// </summary>
    public Func<ModelMoment, SceneDescription>? At { get; init; }
}

/// <summary>An animation in a model file.</summary>
/// <param name="Name">Its name; empty where it has none.</param>
/// <param name="Seconds">The time of its last key.</param>
public sealed record ModelAnimation(string Name, double Seconds);

/// <summary>The time for which a picture shows a model.</summary>
/// <param name="Animation">The number of the animation that is played; without effect where there is none.</param>
/// <param name="Variant">The number of the look; null for that of <see cref="ImportedModel.Scene"/>.</param>
/// <param name="Open">The time of the scene at which the shutter opens, in seconds.</param>
/// <param name="Close">The time at which it closes, not before.</param>
/// <param name="TimeAt">The time in the animation at a time of the scene.</param>
public sealed record ModelMoment(int Animation, int? Variant, double Open, double Close, Func<double, double> TimeAt);

/// <summary>A model file that cannot be read; the message says what is wrong and where (line or byte offset), for the user.</summary>
public sealed class ModelException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public ModelException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong in a line of a text file.</summary>
    /// <param name="reason">The fault and what was expected: one sentence without a final stop.</param>
    /// <param name="line">The line, from 1.</param>
    public ModelException(string reason, int line) : base($"line {line}: {reason}")
    {
        Line = line;
        Reason = reason;
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public ModelException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public ModelException()
    {
    }

    /// <summary>The line of the model's file, from 1; 0 where the fault is in no line.</summary>
    public int Line { get; }

    /// <summary>The complaint without the line; null where there is no line.</summary>
    public string? Reason { get; }
}
