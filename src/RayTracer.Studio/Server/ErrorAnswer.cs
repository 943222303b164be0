using System.Text.Json.Serialization;

namespace RayTracer.Studio;

/// <summary>What a request that is not met is answered with.</summary>
/// <param name="Error">Why, in a sentence for the user.</param>
internal sealed record ErrorAnswer(string Error)
{
    /// <summary>Whether changes that were not saved would be lost.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public bool Unsaved { get; init; }

    /// <summary>Whether there is such a file already.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public bool Exists { get; init; }

    /// <summary>Whether somebody else has changed the file.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public bool ChangedOnDisk { get; init; }
}
