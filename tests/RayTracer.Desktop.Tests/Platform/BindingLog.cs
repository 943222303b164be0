using System.Globalization;
using Avalonia.Logging;

namespace RayTracer.Desktop.Tests;

/// <summary>Keeps what Avalonia says about bindings that have no value, and about other trouble.</summary>
internal sealed class BindingLog : ILogSink
{
    private readonly List<string> _complaints = [];

    /// <summary>What was said since the last time, and forgets it.</summary>
    public string[] Take()
    {
        string[] all = [.. _complaints.Distinct()];
        _complaints.Clear();
        return all;
    }

    public bool IsEnabled(LogEventLevel level, string area) => level >= LogEventLevel.Warning;

    public void Log(LogEventLevel level, string area, object? source, string messageTemplate) => _complaints.Add($"{area}: {source}: {messageTemplate}");

    public void Log(LogEventLevel level, string area, object? source, string messageTemplate, params object?[] propertyValues) =>
        _complaints.Add(string.Create(CultureInfo.InvariantCulture, $"{area}: {source?.GetType().Name}: {messageTemplate}: {string.Join(" | ", propertyValues)}"));
}
