using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Something that is wrong with the text.</summary>
internal sealed record ProblemViewModel(int Line, int Column, int From, int To, bool IsError, string Message)
{
    /// <summary>Where, in words; empty where it is about no place.</summary>
    public string Where => Line > 0 ? SessionTexts.Of("editor.at", Line, Column) : "";
}
