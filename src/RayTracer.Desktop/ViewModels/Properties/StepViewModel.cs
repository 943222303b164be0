using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A record of a list, such as a step of a transform.</summary>
/// <param name="Title">What it is called.</param>
/// <param name="RemoveText">What the button says that takes it away.</param>
/// <param name="Record">Its parameters.</param>
/// <param name="Remove">Takes it away.</param>
internal sealed record StepViewModel(string Title, string RemoveText, RecordViewModel Record, ICommand Remove);
