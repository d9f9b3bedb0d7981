-- | The kinds of picture files, by their names' extensions, and how finely they
-- are coded.
module BlackHole.Image.Coding
  ( Format (..),
    formatOf,
    formatExtensions,
    Coding (..),
    defaultCoding,
    codingProblem,
    codingBitsOf,
    codingQualityOf,
  )
where

import BlackHole.Scene.Problem (Problem (..))
import Data.Char (toLower)
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import System.FilePath (takeExtension)

-- | A file format.
data Format
  = -- | Developed, 8 or 16 bits, lossless.
    Png
  | -- | Developed, 8 bits, lossy.
    Jpeg
  | -- | Developed in 16 bits, or linear light in 32.
    Tiff
  | -- | Radiance's RGBE: linear light, 8 bits and a shared exponent.
    Hdr
  | -- | OpenEXR: linear light in 16 or 32 bits, with layers.
    Exr
  deriving (Eq, Show, Enum, Bounded)

-- | The format of a file of this name; 'Nothing' for other extensions.
formatOf :: FilePath -> Maybe Format
formatOf path = lookup (map toLower (takeExtension path)) formatExtensions

-- | The extensions and their formats.
formatExtensions :: [(String, Format)]
formatExtensions =
  [ (".png", Png),
    (".jpg", Jpeg),
    (".jpeg", Jpeg),
    (".tif", Tiff),
    (".tiff", Tiff),
    (".hdr", Hdr),
    (".exr", Exr)
  ]

-- | What was asked for; 'Nothing' is the format's own.
data Coding = Coding
  { -- | Bits per primary.
    codingBits :: !(Maybe Int),
    -- | JPEG's quality, 1 to 100.
    codingQuality :: !(Maybe Int)
  }
  deriving (Eq, Show)

-- | The format's own defaults.
defaultCoding :: Coding
defaultCoding = Coding Nothing Nothing

-- | The bits a format can have, its own first.
formatBits :: Format -> [Int]
formatBits format = case format of
  Png -> [8, 16]
  Jpeg -> [8]
  Tiff -> [16, 32]
  Hdr -> [8]
  Exr -> [16, 32]

-- | The problems of an encoding for a format.
codingProblem :: Format -> Coding -> [Problem]
codingProblem format (Coding bits quality) =
  [ Problem
      "--bits"
      (show n)
      ( "a number of bits that this format supports: "
          ++ intercalate " or " (map show (formatBits format))
      )
    | Just n <- [bits],
      n `notElem` formatBits format
  ]
    ++ [ Problem "--quality" (show n) "a whole number from 1 to 100"
         | Just n <- [quality],
           n < 1 || n > 100
       ]
    ++ [ Mistake "--quality" (show n ++ " has no effect; it applies only to JPEG files")
         | format /= Jpeg,
           Just n <- [quality]
       ]

-- | The bits per primary.
codingBitsOf :: Format -> Coding -> Int
codingBitsOf format coding = case formatBits format of
  own : _ -> fromMaybe own (codingBits coding)
  [] -> 8

-- | JPEG's quality; 92 unless asked otherwise, where compression starts to be
-- seen in smooth gradients at twice the size.
codingQualityOf :: Coding -> Int
codingQualityOf = fromMaybe 92 . codingQuality
