namespace RayTracer.Imaging;

/// <summary>A file that cannot be written; the message says in one sentence what is wrong, for the user.</summary>
public sealed class ImageWriteException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public ImageWriteException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public ImageWriteException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public ImageWriteException()
    {
    }
}
