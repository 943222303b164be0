namespace RayTracer.Session;

/// <summary>Why something that was asked for is not done.</summary>
public enum SessionFault
{
    /// <summary>What was asked for makes no sense, or cannot be done; the message says why.</summary>
    Refused,

    /// <summary>There is no such thing.</summary>
    Missing,

    /// <summary>Something else has happened meanwhile, or would be lost.</summary>
    Conflict,
}
