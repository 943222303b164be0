namespace RayTracer.Description;

/// <summary>A complaint about one parameter of one description record.</summary>
/// <param name="Subject">The record complained about.</param>
/// <param name="Property">The name of its C# property, or null for the record as a whole.</param>
/// <param name="Message">The fault and what was expected, in one sentence without a final stop.</param>
/// <param name="IsError">True where the scene cannot be rendered; otherwise it is a warning.</param>
public sealed record SceneComplaint(object Subject, string? Property, string Message, bool IsError)
{
    /// <summary>True where a value is outside of its parameter's range.</summary>
    public bool IsOutOfRange { get; init; }

    /// <summary>The message with the record that it is about: <c>SphereDescription "ball", Radius: …</c></summary>
    public override string ToString()
    {
        string name = Subject is ShapeDescription { Name.Length: > 0 } shape ? $" {Quotation.Of(shape.Name)}" : "";
        return $"{Subject.GetType().Name}{name}{(Property is null ? "" : $", {Property}")}: {Message}";
    }
}

/// <summary>A description of which no scene can be made; the message lists everything that is wrong with it.</summary>
public sealed class SceneException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public SceneException(IReadOnlyList<SceneComplaint> complaints) : base(string.Join(Environment.NewLine, complaints.Where(c => c.IsError))) => Complaints = complaints;

    /// <summary>Says what is wrong.</summary>
    public SceneException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public SceneException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public SceneException()
    {
    }

    /// <summary>All complaints, warnings among them.</summary>
    public IReadOnlyList<SceneComplaint> Complaints { get; } = [];
}
