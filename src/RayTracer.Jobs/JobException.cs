namespace RayTracer.Jobs;

/// <summary>Why a job cannot be done.</summary>
public enum JobFault
{
    /// <summary>A file cannot be read or written, or is not what it should be; or there is not enough memory.</summary>
    File,

    /// <summary>The request makes no sense.</summary>
    Request,

    /// <summary>A class of a plug-in threw an exception: the message ends with the first lines of its stack.</summary>
    Plugin,
}

/// <summary>A job that cannot be done.</summary>
public sealed class JobException : Exception
{
    /// <summary>An unnamed fault.</summary>
    public JobException()
    {
    }

    /// <summary>Says that something about a file is wrong.</summary>
    public JobException(string message) : base(message)
    {
    }

    /// <summary>Says that something about a file is wrong, and what caused it.</summary>
    public JobException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>Says what is wrong.</summary>
    /// <param name="fault">Of what kind it is.</param>
    /// <param name="message">The fault and what was expected, in one clause.</param>
    public JobException(JobFault fault, string message) : base(message) => Fault = fault;

    /// <summary>The kind of fault.</summary>
    public JobFault Fault { get; }
}
