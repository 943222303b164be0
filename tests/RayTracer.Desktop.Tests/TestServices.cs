using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Tests;

/// <summary>Answers dialogs by itself, and keeps what is put on the clipboard.</summary>
internal sealed class TestServices : IWindowServices
{
    /// <summary>What is chosen in the next dialog; null for nothing.</summary>
    public string? Chosen { get; set; }

    /// <summary>The titles of the dialogs that were shown.</summary>
    public List<string> Titles { get; } = [];

    /// <summary>What is on the clipboard: a text, or a picture's bytes.</summary>
    public object? Clipboard { get; private set; }

    /// <summary>Closes the window.</summary>
    public Action CloseWindow { get; set; } = () => { };

    public Task<string?> ChooseFile(string title, string? folder, IReadOnlyList<string> extensions) => Answer(title);

    public Task<string?> ChooseNewFile(string title, string? folder, string name) => Answer(title);

    public Task CopyText(string text)
    {
        Clipboard = text;
        return Task.CompletedTask;
    }

    public Task CopyPicture(byte[] png)
    {
        Clipboard = png;
        return Task.CompletedTask;
    }

    public void Close() => CloseWindow();

    private Task<string?> Answer(string title)
    {
        Titles.Add(title);
        return Task.FromResult(Chosen);
    }
}
