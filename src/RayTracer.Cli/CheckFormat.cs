namespace RayTracer.Cli;

/// <summary>How <c>raytracer check</c> says what is wrong.</summary>
internal enum CheckFormat
{
    /// <summary>A line each, as compilers write them.</summary>
    Text,

    /// <summary>A JSON object.</summary>
    Json,

    /// <summary>SARIF 2.1.0, which code hosts and editors show.</summary>
    Sarif,
}
